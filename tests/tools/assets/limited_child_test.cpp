#include "limited_child.hpp"

#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "orbweaver/fault.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

namespace {

const ChildLimits kLimits{std::size_t{512} << 20, 20};

/// How a piece of work ends, in words; the kind is checked.
std::string end_of(FaultKind kind, const ChildLimits& limits, const std::function<std::string()>& work) {
    try {
        return "answer: " + run_in_child("m.obj", limits, work);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == kind);
        return fault.what();
    }
}

}  // namespace

TEST_CASE("a child's answer arrives as it is, whatever its length", "[unit]") {
    for (const std::size_t length : {0u, 1u, 65536u, 5'000'000u}) {
        std::string answer(length, 'x');
        if (length > 0) answer[length / 2] = '\0';
        CHECK(run_in_child("m.obj", kLimits, [&] { return answer; }) == answer);
    }
}

TEST_CASE("a fault of a child's arrives as it is", "[unit]") {
    const auto work = []() -> std::string { throw Fault(FaultKind::diverged, "m.obj: is odd; even it"); };
    CHECK(end_of(FaultKind::diverged, kLimits, work) == "m.obj: is odd; even it");
}

TEST_CASE("a crash in a child becomes a sentence", "[unit]") {
    const std::string remedy = "; export the mesh again, or in another format";
    const auto crash = [](int signal) {
        return [signal]() -> std::string {
            ::raise(signal);
            return "";
        };
    };
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL})
        CHECK(end_of(FaultKind::invalid, kLimits, crash(signal)) ==
              "m.obj: the importer crashed on it (" + std::string(::strsignal(signal)) + ")" + remedy);
    CHECK(end_of(FaultKind::invalid, kLimits, []() -> std::string { throw std::runtime_error("x"); }) ==
          "m.obj: the importer crashed on it (Aborted)" + remedy);
    CHECK(end_of(FaultKind::invalid, kLimits, []() -> std::string { ::_exit(0); }) ==
          "m.obj: the importer crashed on it (it ended without an answer)" + remedy);
}

TEST_CASE("a child that hangs, idle or busy, is ended in time", "[unit]") {
    const ChildLimits limits{kLimits.memory, 0.3};
    const std::string sentence =
        "m.obj: importing it takes longer than 0.3 s; simplify the mesh, or allow more with --time-limit";
    const auto begin = std::chrono::steady_clock::now();
    CHECK(end_of(FaultKind::limit, limits, []() -> std::string {
              for (;;) ::pause();
          }) == sentence);
    CHECK(end_of(FaultKind::limit, limits, []() -> std::string {
              for (volatile bool on = true; on;) {
              }
              return "";
          }) == sentence);
    CHECK(std::chrono::steady_clock::now() - begin <
          std::chrono::seconds(10));  // a busy machine takes its time
}

TEST_CASE("a child that eats memory is ended", "[unit]") {
    const std::string sentence =
        "m.obj: importing it takes more than 512 MB of memory; simplify the mesh, or allow more with "
        "--memory-limit";
    CHECK(end_of(FaultKind::limit, kLimits, []() -> std::string {
              std::vector<std::string> eaten;
              for (;;) eaten.emplace_back(1 << 20, 'x');
          }) == sentence);
    CHECK(end_of(FaultKind::limit, kLimits, [] { return std::string(std::size_t{700} << 20, 'x'); }) ==
          sentence);
    CHECK(end_of(FaultKind::limit, kLimits, []() -> std::string { throw std::bad_alloc(); }) == sentence);
}

TEST_CASE("a child writes no file and says nothing on our streams", "[unit]") {
    const test::Folder folder;
    const std::string path = folder.path("f");
    CHECK(end_of(FaultKind::invalid, kLimits, [&] { return folder.write("f", "x"); }).find("crashed") !=
          std::string::npos);
    CHECK(test::read_file(path).empty());
}
