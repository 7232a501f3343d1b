#include "mesh_commands.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "mesh_file.hpp"
#include "shapes.hpp"
#include "support/program.hpp"

using namespace orbweaver;
using test::run_assets;

TEST_CASE("from a shape to a baked file that is inspected and proved sound", "[unit]") {
    const test::Folder folder;
    for (const mesh::Shape& shape : mesh::shapes()) {
        INFO(shape.name);
        const std::string obj = folder.path("m.obj"), baked = folder.path("made/m.baked");
        REQUIRE(run_assets({"mesh", std::string(shape.name), "-o", obj, "--subdivision", "3", "--size", "2"})
                    .code == 0);
        const auto made =
            run_assets({"adjacency", obj, "-o", baked, "--friction", std::string(shape.name) + "=0.2"});
        REQUIRE(made.code == 0);
        CHECK(run_assets({"inspect", baked}).out == made.out);
        const auto json = nlohmann::json::parse(run_assets({"inspect", baked, "--json"}).out);
        CHECK(json["materials"][0]["friction"] == 0.2);
        CHECK(json["source_polygons"] == shape.make(2, 3).polygon_count());
        const auto proof = run_assets({"verify", baked});
        CHECK(proof.code == 0);
        CHECK(proof.out == baked + ": sound\n");
    }
}

TEST_CASE("what is wrong with a mesh or a baked file is a sentence and exit code 3", "[unit]") {
    const test::Folder folder;
    const std::string out = folder.path("m.baked");
    const std::string obj = folder.path("cube.obj");
    REQUIRE(run_assets({"mesh", "cube", "-o", obj}).code == 0);
    for (const auto& arguments :
         std::vector<std::vector<std::string>>{{"adjacency", folder.path("none.obj"), "-o", out},
                                               {"adjacency", folder.write("empty.obj", ""), "-o", out},
                                               {"adjacency", obj, "-o", out, "--friction", "glass=1"},
                                               {"inspect", obj},
                                               {"verify", obj},
                                               {"inspect", folder.path("none")}}) {
        const auto outcome = run_assets(arguments);
        CHECK(outcome.code == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.starts_with("error: "));
        CHECK(outcome.err.find("; ") != std::string::npos);
    }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a mesh that takes more memory or time than is allowed is a sentence and exit code 5", "[unit]") {
    const test::Folder folder;
    const std::string obj = folder.path("m.obj"), out = folder.path("m.baked");
    REQUIRE(run_assets({"mesh", "torus", "-o", obj, "--subdivision", "250"}).code ==
            0);  // half a million quads
    const auto hungry = run_assets({"adjacency", obj, "-o", out, "--memory-limit", "32"});
    CHECK(hungry.code == 5);
    CHECK(hungry.err == "error: " + obj +
                            ": importing it takes more than 32 MB of memory; simplify the mesh, or allow more "
                            "with --memory-limit\n");
    const auto slow = run_assets({"adjacency", obj, "-o", out, "--time-limit", "0.1"});
    CHECK(slow.code == 5);
    CHECK(slow.err == "error: " + obj +
                          ": importing it takes longer than 0.1 s; simplify the mesh, or allow more with "
                          "--time-limit\n");
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a wrong command line is exit code 2", "[unit]") {
    CHECK(run_assets({"mesh", "cubes", "-o", "x"}).code == 2);
    CHECK(run_assets({"mesh", "cube"}).code == 2);
    CHECK(run_assets({"mesh", "cube", "-o", "x", "--size", "0"}).code == 2);
    CHECK(run_assets({"adjacency", "x", "-o", "y", "--friction", "glass"}).code == 2);
    CHECK(run_assets({"adjacency", "x", "-o", "y", "--friction", "glass=-1"}).code == 2);
    CHECK(run_assets({"adjacency", "x", "-o", "y", "--friction", "=1"}).code == 2);
    CHECK(run_assets({"adjacency", "x", "-o", "y", "--weld", "-1"}).code == 2);
    CHECK(run_assets({"inspect"}).code == 2);
}

// Files of the past, kept: whatever version comes, they are read or refused, never misread.
TEST_CASE("baked files of earlier versions are refused in words", "[unit]") {
    const std::string kept = ORBWEAVER_SOURCE_DIR "/tests/fixtures/baked/";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"cube_container_0.baked",
         "is a baked file of version 0; expected 1, so bake it again with orbweaver-assets"},
        {"cube_mesh_0.baked", "holds a mesh of version 0; expected 3, so bake it again with orbweaver-assets"},
        {"cube_mesh_1.baked", "holds a mesh of version 1; expected 3, so bake it again with orbweaver-assets"},
        {"cube_mesh_2.baked", "holds a mesh of version 2; expected 3, so bake it again with orbweaver-assets"},
        {"cube_other_byte_order.baked",
         "was baked on a machine of the other byte order; bake it again on this one"}};
    for (const auto& [name, sentence] : cases) {
        const auto outcome = run_assets({"verify", kept + name});
        CHECK(outcome.code == 3);
        CHECK(outcome.err == "error: " + kept + name + ": " + sentence + "\n");
    }
    CHECK(run_assets({"verify", kept + "cube_mesh_3.baked"}).out == kept + "cube_mesh_3.baked: sound\n");
}
