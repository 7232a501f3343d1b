#include "output/progress.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdio>
#include <thread>

#include "support/folder.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

template <class Call>
void with_errors_to(const std::string& path, Call&& call) {
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
    REQUIRE(file >= 0);
    ::dup2(file, STDERR_FILENO);
    ::close(file);
    call();
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
}

/// What a call writes to standard error when that is a file.
template <class Call>
std::string written(Call&& call) {
    const Folder folder;
    with_errors_to(folder.path("err"), call);
    return read_file(folder.path("err"));
}

}  // namespace

TEST_CASE("units of another kind are named, and not compared with real time", "[unit]") {
    const std::string text = written([] {
        Progress progress("study", 0, 3, 0, false, "runs");
        progress.update(3);
    });
    CHECK(text == "study 3/3 runs, 0 s left\n");
}

TEST_CASE("away from a terminal progress is plain lines, the last one when all is done", "[unit]") {
    const std::string text = written([] {
        Progress progress("meadow", 0, 100, 0.1, false);
        for (std::uint64_t i = 1; i <= 100; ++i) progress.update(i);
    });
    CHECK_THAT(text,
               Catch::StartsWith("meadow 100/100 frames, ") && Catch::EndsWith(" x real time, 0 s left\n"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK(text.find('\r') == std::string::npos);
    CHECK(text.find('\033') == std::string::npos);
}

TEST_CASE("quiet progress says nothing", "[unit]") {
    CHECK(written([] {
              Progress progress("meadow", 0, 2, 0.1, true);
              progress.update(1);
              progress.update(2);
          }) == "");
}

TEST_CASE("frames of an earlier run count neither for the pace nor for the time left", "[unit]") {
    const std::string text = written([] {
        Progress progress("meadow", 1000000, 1000001, 1, false);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        progress.update(1000001);
    });
    double factor = 0;
    REQUIRE(std::sscanf(text.c_str(), "meadow 1000001/1000001 frames, %lf x", &factor) == 1);
    CHECK(factor > 0);
    CHECK(factor <= 50);
}

TEST_CASE("progress that cannot be shown is no failure", "[extreme]") {
    with_errors_to("/dev/full", [] {
        Progress progress("meadow", 0, 1, 0.1, false);
        CHECK_NOTHROW(progress.update(1));
    });
}
