#include "stride.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "geodesic.hpp"
#include "obj_mesh.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::built;

namespace {

struct World {
    mesh::SurfaceMeshData data;
    mesh::SurfaceMesh mesh;
    ReadyParts parts;
    std::uint32_t shells;

    explicit World(const mesh::RawMesh& raw)
        : data(built(raw)), mesh(data.view()), parts(mesh), shells(mesh.shell.back() + 1) {}

    Footing standing(const Vec3& position, const Vec3& up, const Vec3& forward) const {
        const WideTreeData all = build_wide_tree(triangles_of(mesh));
        const SurfaceHit hit = closest_point(all.view(), triangles_of(mesh), position, 1);
        REQUIRE(hit.answer == Answer::found);
        return place(mesh, hit.at, up, forward).end;
    }
};

mesh::RawMesh joined(mesh::RawMesh a, const mesh::RawMesh& b) {
    const auto base = static_cast<std::uint32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (std::size_t p = 0; p < b.polygon_count(); ++p) {
        for (std::uint32_t c = b.first[p]; c < b.first[p + 1]; ++c) a.corners.push_back(base + b.corners[c]);
        a.first.push_back(static_cast<std::uint32_t>(a.corners.size()));
        a.material.push_back(0);
    }
    return a;
}

}  // namespace

TEST_CASE("a stride senses the wall of a room before it is reached, and ends on it", "[unit]") {
    const World room(mesh::room(2, 4));
    std::array<StrideCorner, 4> corners;
    const Footing begin = room.standing({0.21, -1, 0.13}, {0, 1, 0}, {1, 0, 0});
    const SurfaceStride found = stride(room.mesh, room.shells, room.parts, begin, 1, corners);
    REQUIRE(found.step.answer == Answer::found);
    CHECK(distance(found.step.end.position, {1, -0.79, 0.13}) < 1e-14);
    REQUIRE(found.corners == 1);
    CHECK(corners[0].distance == Approx(0.79).epsilon(1e-14));
    CHECK(corners[0].rises);
    CHECK(distance(corners[0].position, {1, -1, 0.13}) < 1e-14);
    CHECK(corners[0].up_after == Vec3{-1, 0, 0});
    CHECK(room.parts.tree_bytes() == 0);
}

TEST_CASE("a stride over a cube's edge tells that the surface drops", "[unit]") {
    const World cube(mesh::cube(2, 3));
    std::array<StrideCorner, 1> corners;
    const Footing begin = cube.standing({0.21, 1, 0.13}, {0, 1, 0}, {1, 0, 0});
    const SurfaceStride found = stride(cube.mesh, cube.shells, cube.parts, begin, 3, corners);
    CHECK(found.corners == 2);  // more were met than there was room for
    CHECK(corners[0].distance == Approx(0.79).epsilon(1e-14));
    CHECK_FALSE(corners[0].rises);
    CHECK(distance(found.step.end.position, {0.79, -1, 0.13}) < 1e-14);
}

TEST_CASE("a cliff that leans out is climbed: wall, overhang, plateau", "[unit]") {
    const World cliff(mesh::cliff(2, 4));
    std::array<StrideCorner, 4> corners;
    const Footing begin = cliff.standing({-0.5, 0, 0.1}, {0, 1, 0}, {1, 0, 0});
    const double wall = std::sqrt(0.25 + 1);
    const SurfaceStride found = stride(cliff.mesh, cliff.shells, cliff.parts, begin, 0.5 + wall + 0.4, corners);
    CHECK(distance(found.step.end.position, {-0.1, 1, 0.1}) < 1e-14);
    CHECK(distance(found.step.end.up, {0, 1, 0}) < 1e-14);
    REQUIRE(found.corners == 2);
    CHECK(corners[0].rises);
    CHECK(corners[0].up_after.y < 0);  // overhanging
    CHECK_FALSE(corners[1].rises);
}

TEST_CASE("a crate that only stands in a floor is climbed and left again", "[unit]") {
    // Two shells that pass through each other: no edge joins them.
    const World scene(
        joined(mesh::t_junction(4, 8), mesh::transformed(mesh::cube(1, 2), 1, {0.01, 0.1, 0.03})));
    REQUIRE(scene.shells == 3);  // the floor's halves are not joined either
    std::array<StrideCorner, 8> corners;
    const Footing begin = scene.standing({-1.29, 0, 0.1}, {0, 1, 0}, {1, 0, 0});
    const SurfaceStride up = stride(scene.mesh, scene.shells, scene.parts, begin, 0.8 + 0.2, corners);
    CHECK(distance(up.step.end.position, {-0.49, 0.2, 0.1}) < 1e-6);  // of the size: the height of the feeler
    CHECK(distance(up.step.end.up, {-1, 0, 0}) < 1e-14);
    REQUIRE(up.corners == 1);
    CHECK(corners[0].rises);
    const SurfaceStride over =
        stride(scene.mesh, scene.shells, scene.parts, begin, 0.8 + 0.6 + 1 + 0.6 + 0.3, corners);
    CHECK(distance(over.step.end.position, {0.81, 0, 0.1}) < 4e-6);
    CHECK(distance(over.step.end.up, {0, 1, 0}) < 1e-14);
    CHECK(over.corners == 4);
}

TEST_CASE("across a T-junction the stride goes on, at the floor's end it stops", "[unit]") {
    const World floor(mesh::t_junction(2, 4));
    const Footing begin = floor.standing({-0.5, 0, 0.11}, {0, 1, 0}, {1, 0, 0});
    CHECK(step(floor.mesh, begin, 1).stop == StepStop::border);
    const SurfaceStride found = stride(floor.mesh, floor.shells, floor.parts, begin, 1, {});
    CHECK(found.step.stop == StepStop::none);
    CHECK(distance(found.step.end.position, {0.5, 0, 0.11}) < 1e-6);
    CHECK(found.corners == 0);
    CHECK(stride(floor.mesh, floor.shells, floor.parts, begin, 5, {}).step.stop == StepStop::border);
}
