#include "part_file.hpp"

#include <catch2/catch.hpp>
#include <cerrno>

#include "file_size_limit.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::film;

namespace {

const std::uint8_t kBytes[4096] = {1, 2, 3};

FaultRecord caught(const std::filesystem::path& path) {
    try {
        write_whole(path, kBytes);
    } catch (const Fault& e) {
        return {e.kind(), e.what()};
    }
    return {FaultKind::internal, "written"};
}

}  // namespace

TEST_CASE("a whole file gets its name, and replaces an older one", "[unit]") {
    const test::Scratch scratch;
    scratch.write("a.bin", "old");
    write_whole(scratch.path("a.bin"), kBytes);
    CHECK(std::filesystem::file_size(scratch.path("a.bin")) == sizeof kBytes);
    CHECK(scratch.count() == 1);
    CHECK(part_path("x/film.mp4") == "x/.film.part.mp4");
}

TEST_CASE("a full disk is a limit, and nothing half-written stays", "[extreme]") {
    const test::Scratch scratch;
    {
        const test::FileSizeLimit full(1000);
        const auto fault = caught(scratch.path("a.bin"));
        CHECK(fault.kind == FaultKind::limit);
        CHECK(fault.sentence ==
              "Writing " + scratch.path("a.bin") + " failed: File too large; make room or write elsewhere.");
    }
    CHECK(scratch.count() == 0);

    // The part's name leads to the device that is always full.
    std::filesystem::create_symlink("/dev/full", scratch.path(".b.part.bin"));
    const auto fault = caught(scratch.path("b.bin"));
    CHECK(fault.kind == FaultKind::limit);
    CHECK(fault.sentence.find("No space left on device") != std::string::npos);
    CHECK(scratch.count() == 0);
}

TEST_CASE("each errno has its kind of fault", "[unit]") {
    for (const int full : {ENOSPC, EDQUOT, EFBIG})
        CHECK(io_fault("Writing", "a", full).kind() == FaultKind::limit);
    for (const int other : {EIO, EACCES, ENOENT})
        CHECK(io_fault("Writing", "a", other).kind() == FaultKind::internal);
}

TEST_CASE("a directory that cannot be made or written to is refused in words", "[extreme]") {
    const test::Scratch scratch;
    const auto file = scratch.write("file", "");
    CHECK_THROWS_WITH(
        make_writable_directory(file),
        "Making the directory " + file + " failed: Not a directory; check the path and its permissions.");
    CHECK_THROWS_AS(make_writable_directory(file + "/below"), Fault);
    CHECK_THROWS_AS(make_writable_directory("/proc/nothing"), Fault);
    make_writable_directory(scratch.path("a/b/c"));
    CHECK(std::filesystem::is_empty(scratch.path("a/b/c")));

    if (geteuid() == 0) return;  // permissions bind everyone but root
    std::filesystem::permissions(scratch.path("a"), std::filesystem::perms::owner_read);
    CHECK_THROWS_AS(make_writable_directory(scratch.path("a/d")), Fault);
    std::filesystem::permissions(scratch.path("a"), std::filesystem::perms::owner_all);
}
