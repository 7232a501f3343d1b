#include "baked_commands.hpp"

#include <catch2/catch.hpp>

#include "support/program.hpp"

using namespace orbweaver;
using test::run_assets;

TEST_CASE("a damaged target is refused in words", "[unit]") {
    const test::Folder folder;
    const std::string baked = folder.path("t.baked");
    REQUIRE(run_assets({"target", "--gaps", "0.1", "-o", baked, "--size", "64"}).code == 0);
    std::string bytes = test::read_file(baked);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    folder.write("t.baked", bytes);
    for (const char* command : {"inspect", "verify"}) {
        const auto outcome = run_assets({command, baked});
        CHECK(outcome.code == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err ==
              "error: " + baked + ": is damaged: its checksum is wrong; bake it again with orbweaver-assets\n");
    }
}

// A file of the past, kept: see mesh_commands_test.cpp.
TEST_CASE("a target of version 1 is sound, and made again gives the same bytes", "[unit]") {
    const test::Folder folder;
    const std::string kept = ORBWEAVER_SOURCE_DIR "/tests/fixtures/baked/gaps_target_1.baked";
    CHECK(run_assets({"verify", kept}).out == kept + ": sound\n");
    REQUIRE(run_assets({"target", "--gaps", "0.1", "--size", "48", "-o", folder.path("t")}).code == 0);
    CHECK(test::read_file(folder.path("t")) == test::read_file(kept));
}

TEST_CASE("a mesh is not drawn", "[unit]") {
    const std::string mesh = ORBWEAVER_SOURCE_DIR "/tests/fixtures/baked/cube_mesh_3.baked";
    const auto outcome = run_assets({"inspect", mesh, "--png", "x.png"});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.starts_with("--png: " + mesh + " holds a mesh; expected a target, which can be drawn"));
    CHECK(run_assets({"inspect", mesh}).code == 0);
}

TEST_CASE("a target is not drawn over itself", "[unit]") {
    const test::Folder folder;
    const std::string baked = folder.path("t.baked");
    REQUIRE(run_assets({"target", "--gaps", "0.1", "-o", baked, "--size", "64"}).code == 0);
    const std::string before = test::read_file(baked);
    const auto outcome = run_assets({"inspect", baked, "--png", folder.path("./t.baked")});
    CHECK(outcome.code == 2);
    CHECK(outcome.err.starts_with("--png: " + folder.path("./t.baked") +
                                  " is what is to be drawn; name another"));
    CHECK(test::read_file(baked) == before);
}
