#include "output/progress.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "support/folder.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

/// What a call writes to standard error when that is a file.
template <class Call>
std::string written(Call&& call) {
    const Folder folder;
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    const int file = ::open(folder.path("err").c_str(), O_WRONLY | O_CREAT, 0600);
    REQUIRE(file >= 0);
    ::dup2(file, STDERR_FILENO);
    ::close(file);
    call();
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    return read_file(folder.path("err"));
}

}  // namespace

TEST_CASE("away from a terminal progress is plain lines, the last one when all is done", "[unit]") {
    const std::string text = written([] {
        Progress progress("meadow", 100, 0.1, false);
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
              Progress progress("meadow", 2, 0.1, true);
              progress.update(1);
              progress.update(2);
          }) == "");
}
