#include "mesh_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "bake_mesh.hpp"
#include "mesh_file.hpp"
#include "obj.hpp"
#include "output/atomic_file.hpp"
#include "shapes.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

namespace {

/// A quad of glass; beside it the same triangle twice, the second one turned over; one without area.
constexpr const char* kSource =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nusemtl glass\nf 1 2 3 4\nusemtl bark\nf 2 5 3\nf 2 3 5\nf 1 "
    "2 5\n";

BakedFile bake_sample(const test::Folder& folder) {
    bake_mesh(folder.write("m.obj", kSource), {0, {{"glass", {0.25, 0, 0}}}}, {}, folder.path("m.baked"));
    return {folder.path("m.baked"), mesh::kMeshType, mesh::kMeshVersion};
}

}  // namespace

TEST_CASE("a program reads what a mesh holds and what was found in it", "[unit]") {
    const test::Folder folder;
    const auto json = nlohmann::json::parse(mesh_json(bake_sample(folder)));
    CHECK(json["kind"] == "mesh");
    CHECK(json["version"] == mesh::kMeshVersion);
    CHECK(json["source_hash"].get<std::string>().size() == 32);
    CHECK(json["triangles"] == 3);
    CHECK(json["polygons"] == 2);
    CHECK(json["vertices"] == 5);
    CHECK(json["edges"] == 7);
    CHECK(json["border_edges"] == 5);
    CHECK(json["nonmanifold_edges"] == 0);
    CHECK(json["t_junctions"] == 0);
    CHECK(json["shells"] == 1);
    CHECK(json["dropped_degenerate"] == 1);
    CHECK(json["dropped_duplicate"] == 1);
    CHECK(json["flipped"] == 0);
    CHECK(json["bounds"]["max"] == std::vector<double>{2, 1, 0});
    CHECK(json["materials"][0] == nlohmann::json{{"name", "glass"}, {"friction", 0.25}, {"climbable", false}});
    CHECK(json["materials"][1] == nlohmann::json{{"name", "bark"}, {"friction", 0.6}, {"climbable", true}});
}

TEST_CASE("a person reads the same", "[unit]") {
    const test::Folder folder;
    const std::string text = mesh_text(bake_sample(folder));
    for (const char* line :
         {"  3 triangles of 2 polygons, 5 vertices, 7 edges, 1 shell\n",
          "  x 0 to 2 m, y 0 to 1 m, z 0 to 0 m\n", "  'glass': friction 0.25, not climbable\n",
          "  'bark': friction 0.6, climbable\n", "  dropped degenerate    1 (first: polygon 3)\n",
          "  dropped duplicate     1 (first: polygon 2)\n",
          "  border edges          5 (first: triangle 0)\n"}) {
        INFO(text);
        CHECK(text.find(line) != std::string::npos);
    }
}

TEST_CASE("T-junctions that survive the import are told, with the first", "[unit]") {
    const test::Folder folder;
    AtomicFile source(folder.path("t.obj"));
    source.write(obj_text(mesh::t_junction(2, 4)));
    source.commit();
    bake_mesh(folder.path("t.obj"), {}, {}, folder.path("t.baked"));
    const BakedFile baked(folder.path("t.baked"), mesh::kMeshType, mesh::kMeshVersion);
    CHECK(nlohmann::json::parse(mesh_json(baked))["t_junctions"] == 4);
    CHECK_THAT(mesh_text(baked), Catch::Contains("  T-junctions           4 (first: vertex "));
}
