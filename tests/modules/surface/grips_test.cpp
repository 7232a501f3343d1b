#include "grips.hpp"

#include <catch2/catch.hpp>

#include "obj_mesh.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;

namespace {

/// A cube of six quads, the first of another material.
mesh::SurfaceMeshData two_materials() {
    mesh::RawMesh raw = mesh::cube(1, 1);
    raw.material_names = {"stone", "glass"};
    raw.material[0] = 1;
    return test::built(raw);
}

}  // namespace

TEST_CASE("what is said of a patch counts before its material, and that before the whole", "[unit]") {
    const auto data = two_materials();
    const auto mesh = data.view();
    const double baked = mesh::SurfaceProperty{}.friction;
    GripOverrides grips;
    CHECK(grips.grip(mesh, 0).friction == baked);
    CHECK(grips.grip(mesh, 0).climbable);
    grips.all = {0.5, false};
    CHECK(grips.grip(mesh, 0).friction == 0.5);
    CHECK_FALSE(grips.grip(mesh, 11).climbable);
    grips.materials = {{}, {0.1, std::nullopt}};
    for (std::uint32_t face = 0; face < 12; ++face) {
        CHECK(grips.grip(mesh, face).friction == (mesh.polygon[face] == 0 ? 0.1 : 0.5));
        CHECK_FALSE(grips.grip(mesh, face).climbable);  // it says nothing of that
    }
    grips.patches = {{std::nullopt, true}, {3.0, std::nullopt}};
    grips.patched = {{0, 0, 0}, {2, 2, 1}, {5, 5, 1}};
    for (std::uint32_t face = 0; face < 12; ++face) {
        const std::uint32_t polygon = mesh.polygon[face];
        CHECK(grips.grip(mesh, face).friction == (polygon == 0 ? 0.1 : polygon == 2 || polygon == 5 ? 3 : 0.5));
        CHECK(grips.grip(mesh, face).climbable == (polygon == 0));
    }
}

TEST_CASE("a range is held as one, however many polygons it has", "[unit]") {
    const auto data = test::built(mesh::height_field(1, 40));
    GripOverrides grips;
    grips.patches = {{0.1, std::nullopt}, {0.2, std::nullopt}};
    grips.patched = {{100, 299, 0}, {300, 300, 1}, {1500, 1599, 1}};
    for (std::uint32_t face = 0; face < data.triangles.size(); ++face) {
        const std::uint32_t polygon = data.polygon[face];
        const double expected = polygon >= 100 && polygon < 300     ? 0.1
                                : polygon == 300 || polygon >= 1500 ? 0.2
                                                                    : mesh::SurfaceProperty{}.friction;
        REQUIRE(grips.grip(data.view(), face).friction == expected);
    }
}

TEST_CASE("lists of polygons are numbers and ranges between commas, and nothing else", "[unit]") {
    using Ranges = std::vector<PolygonRange>;
    CHECK(parse_polygons("7") == Ranges{{7, 7}});
    CHECK(parse_polygons(" 0-11, 15 ,3 - 4 ") == Ranges{{0, 11}, {15, 15}});
    CHECK(parse_polygons("9, 4-5, 6, 2-2,2") == Ranges{{2, 2}, {4, 6}, {9, 9}});
    CHECK(parse_polygons("0-4294967295, 7, 0-4294967295") == Ranges{{0, 0xFFFFFFFF}});
    CHECK(parse_polygons("4294967295") == Ranges{{0xFFFFFFFF, 0xFFFFFFFF}});
    for (const char* wrong : {"", " ", ",", "1,", ",1", "1 2", "2-1", "1-", "-1", "1--2", "1-2-3", "x", "1x",
                              "1.5", "4294967296", "+1"}) {
        CAPTURE(wrong);
        CHECK_FALSE(parse_polygons(wrong));
    }
}
