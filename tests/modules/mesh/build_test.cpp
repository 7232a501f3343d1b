#include "build.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;
using test::build;
using test::raw_mesh;

TEST_CASE("a polygon keeps its identity through its triangles", "[unit]") {
    const SurfaceMeshData mesh = build(cube(1, 2));
    REQUIRE(mesh.triangles.size() == 2 * 6 * 4);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) CHECK(mesh.polygon[t] == t / 2);
}

TEST_CASE("triangles without area are dropped, and where first is said", "[unit]") {
    Validation validation;
    const SurfaceMeshData mesh =
        build(raw_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}, {1, 0, 0}},
                       {{0, 1, 2}, {0, 4, 1}, {0, 1, 5}, {0, 2, 3}, {2, 2, 3}}),
              validation);
    CHECK(validation.dropped_degenerate == 3);  // corners in a line; two corners in one place; one corner twice
    CHECK(validation.first_degenerate == 1);
    CHECK(validation.welded_points == 1);
    CHECK(validation.unused_points == 1);
    CHECK(mesh.polygon == std::vector<std::uint32_t>{0, 3});
    CHECK(mesh.vertices.size() == 4);
}

TEST_CASE("the second of two triangles over the same vertices is dropped, however it is wound", "[unit]") {
    Validation validation;
    const SurfaceMeshData mesh =
        build(raw_mesh(test::kSquare, {{0, 1, 2}, {0, 2, 3}, {1, 2, 0}, {2, 1, 0}, {3, 0, 2}}), validation);
    CHECK(validation.dropped_duplicate == 3);
    CHECK(validation.first_duplicate == 2);
    CHECK(mesh.polygon == std::vector<std::uint32_t>{0, 1});
    CHECK(validation.flipped == 0);
}

TEST_CASE("a flipped face is kept, and its edges say so", "[unit]") {
    Validation validation;
    const SurfaceMeshData mesh = build(
        raw_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 2}, {0, 4, 1}}),
        validation);
    CHECK(validation.flipped == 1);
    CHECK(validation.first_flipped == 1);
    CHECK(mesh.triangles.size() == 3);
    CHECK(is_flipped(mesh.across[0][2]));
    CHECK_FALSE(is_flipped(mesh.across[0][0]));
}

TEST_CASE("soup is sewn together: a cube of separate triangles is closed", "[unit]") {
    const RawMesh sewn = cube(2, 3);
    RawMesh soup;
    soup.material_names = sewn.material_names;
    for (std::size_t p = 0; p < sewn.polygon_count(); ++p) {
        const auto base = static_cast<std::uint32_t>(soup.points.size());
        for (std::uint32_t c = sewn.first[p]; c < sewn.first[p + 1]; ++c)
            soup.points.push_back(sewn.points[sewn.corners[c]]);
        soup.add_polygon({base, base + 1, base + 2, base + 3});
    }
    Validation validation;
    const SurfaceMeshData mesh = build(soup, validation);
    CHECK(validation.border_edges == 0);
    CHECK(validation.shells == 1);
    CHECK(mesh.vertices.size() == 6 * 9 + 2);
    CHECK(validation.welded_points == soup.points.size() - mesh.vertices.size());
}

TEST_CASE("a material says how its faces are to feet", "[unit]") {
    RawMesh raw = raw_mesh(test::kSquare, {{0, 1, 2}});
    raw.material_names = {"bark", "glass"};
    raw.add_polygon({0, 2, 3}, 1);
    Validation validation;
    const SurfaceMeshData mesh = build_surface_mesh(raw, {0, {{"glass", {0.1, 0, 0}}}}, "m", validation);
    CHECK(mesh.property == std::vector<std::uint16_t>{0, 1});
    CHECK(mesh.properties[0] == SurfaceProperty{});
    CHECK(mesh.properties[1] == SurfaceProperty{0.1, 0, 0});
    CHECK(material_name(mesh.view(), 1) == "glass");
    CHECK_THROWS_WITH(build_surface_mesh(raw, {0, {{"glas", {}}}}, "m", validation),
                      "m: there is no material 'glas'; expected one of 'bark', 'glass'");
}

TEST_CASE("the same mesh comes out at every scale, and far from the origin", "[unit]") {
    for (const Shape& shape : shapes()) {
        INFO(shape.name);
        const RawMesh raw = shape.make(1, 2);
        Validation expected, found;
        const SurfaceMeshData mesh = build(raw, expected);
        for (const auto& moved :
             {transformed(raw, 1e-8, {}), transformed(raw, 1e6, {}), transformed(raw, 1, {1e6, -1e6, 1e6})}) {
            const SurfaceMeshData other = build(moved, found);
            CHECK(found == expected);
            CHECK(other.triangles == mesh.triangles);
            CHECK(other.across == mesh.across);
        }
    }
}

TEST_CASE("a mesh of which nothing remains is refused", "[unit]") {
    CHECK_THROWS_WITH(build(raw_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})),
                      "sample: no polygon of the mesh has an area; export it again");
}
