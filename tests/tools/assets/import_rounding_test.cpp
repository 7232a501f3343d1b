#include "import_rounding.hpp"

#include <catch2/catch.hpp>

#include "import_mesh.hpp"
#include "obj.hpp"
#include "shapes.hpp"
#include "support/folder.hpp"
#include "support/program.hpp"

using namespace orbweaver;

namespace {

/// As a file gives it to us: rounded to single precision.
ImportRounding imported(const mesh::RawMesh& raw) {
    const test::Folder folder;
    return import_rounding(import_mesh(folder.write("m.obj", obj_text(raw)), {}).raw);
}

}  // namespace

TEST_CASE("near its file's origin no shape is misshaped, of whatever size", "[unit]") {
    for (const mesh::Shape& shape : mesh::shapes())
        for (const double size : {1e-30, 1e-8, 1.0, 1e6, 1e30}) {
            CAPTURE(shape.name, size);
            CHECK(imported(shape.make(size, 4)).polygons == 0);
        }
}

// Single precision has 24 bits: half a unit in the last place is 2^-4 m from 2^20 m on, at each end of an edge
// of 1 m. Each face of the cube has an edge whose ends are both beyond.
TEST_CASE("far from it the edges are named that may have changed by more than a hundredth", "[unit]") {
    const auto cube_at = [](double x) { return imported(mesh::transformed(mesh::cube(1, 1), 1, {x, 0, 0})); };
    const ImportRounding far = cube_at(0x1p20 + 1);
    CHECK(far.polygons == 6);
    CHECK(far.first == 0);
    CHECK(far.worst == Approx(0x1p-4).epsilon(1e-3));
    CHECK(far.farthest == Approx(0x1p20 + 1.5).epsilon(1e-6));
    CHECK(cube_at(0x1p17 + 1).polygons == 6);  // 2^-7 m at each end: more than a hundredth
    CHECK(cube_at(0x1p16 + 1).polygons == 0);  // 2^-8 m: less
}

TEST_CASE(
    "corners that have become one are told where rounding may have joined them, and not where they were one",
    "[unit]") {
    mesh::RawMesh quad;
    quad.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}};
    quad.material_names = {"paper"};
    quad.add_polygon({0, 1, 2, 3});
    CHECK(import_rounding(quad).polygons == 0);
    CHECK(import_rounding(mesh::transformed(quad, 1, {1e9, 0, 0})).polygons == 1);
    CHECK(imported(mesh::transformed(mesh::sphere(1, 4), 1, {1e12, 1e12, 1e12})).polygons == 128);
}

TEST_CASE("what is lost is said with its remedy, and the baked file keeps it", "[unit]") {
    const test::Folder folder;
    const std::string far =
        folder.write("far.obj", obj_text(mesh::transformed(mesh::cube(1, 2), 1, {1e7, 0, 0})));
    const test::Outcome told = test::run_assets({"adjacency", far, "-o", folder.path("far.baked")});
    CHECK(told.code == 0);
    CHECK_THAT(
        told.err,
        Catch::Contains(far + ": 24 of 24 polygons, the first of them 0, may have edges more than 1 "
                              "% too long or too short: meshes are imported in single precision, in which "
                              "a point 1e+07 m from the file's origin may lie 0.5 m beside its place; move "
                              "the mesh to its file's origin, and give the place where it belongs by "
                              "'position' in the scene\n"));
    CHECK_THAT(told.out, Catch::Contains("  rounded polygons      24\n"));
    const std::string tiny = folder.write("tiny.obj", "v 0 0 0\nv 1e-44 0 0\nv 0 1e-44 0\nf 1 2 3\n");
    CHECK_THAT(
        test::run_assets({"adjacency", tiny, "-o", folder.path("tiny.baked")}).err,
        Catch::Contains("lengths as small as 1.2e-38 m lose their digits; scale its file up, and give the size "
                        "that it should have by 'size' in the scene\n"));
    const std::string none =
        folder.write("none.obj", obj_text(mesh::transformed(mesh::cube(1, 2), 1, {1e12, 1e12, 1e12})));
    const test::Outcome lost = test::run_assets({"adjacency", none, "-o", folder.path("none.baked")});
    CHECK(lost.code == 3);
    CHECK_THAT(lost.err, Catch::Contains("move the mesh to its file's origin") &&
                             Catch::Contains(none + ": no polygon of the mesh has an area; export it again"));
    const std::string huge = folder.write("huge.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1e39 0\nf 1 2 3\n");
    const test::Outcome beyond = test::run_assets({"adjacency", huge, "-o", folder.path("huge.baked")});
    CHECK(beyond.code == 3);
    CHECK_THAT(beyond.err, Catch::Contains("expected finite coordinates within 1e50 m, so scale it down"));
}
