#include "shells.hpp"

#include <catch2/catch.hpp>

#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

Shells shells_of(const std::vector<Triangle>& triangles, std::uint32_t vertices) {
    return find_shells(triangles, build_adjacency(triangles, vertices));
}

}  // namespace

TEST_CASE("shells are what edges hold together, numbered by their lowest triangle", "[unit]") {
    const Shells shells = shells_of({{0, 1, 2}, {3, 4, 5}, {2, 1, 6}, {2, 7, 8}}, 9);
    CHECK(shells.shell == std::vector<std::uint32_t>{0, 1, 0, 2});
    CHECK(shells.count == 3);
    CHECK(shells.flipped == 0);
    CHECK(shells.first_flipped == kNone);
}

TEST_CASE("an edge of three faces holds a shell together", "[unit]") {
    const Shells shells = shells_of({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {3, 1, 5}}, 6);
    CHECK(shells.count == 1);
    CHECK(shells.one_sided == 0);
}

TEST_CASE("the fewer triangles of a shell are the flipped ones, whichever comes first", "[unit]") {
    SurfaceMeshData mesh = test::build(cube(1, 4));
    for (const std::size_t flipped : {std::size_t{0}, std::size_t{17}, mesh.triangles.size() - 1}) {
        auto triangles = mesh.triangles;
        std::swap(triangles[flipped][1], triangles[flipped][2]);
        const Shells shells = shells_of(triangles, static_cast<std::uint32_t>(mesh.vertices.size()));
        CHECK(shells.count == 1);
        CHECK(shells.flipped == 1);
        CHECK(shells.first_flipped == flipped);
        CHECK(shells.one_sided == 0);
    }
}

TEST_CASE("a Moebius strip has one side, a ring without a twist has two", "[unit]") {
    CHECK(test::build(moebius_strip(1, 3)).shell.size() == 8 * 3 * 3 * 2);
    Validation strip, ring;
    test::build(moebius_strip(1, 3), strip);
    test::build(torus(1, 3), ring);
    CHECK(strip.one_sided_shells == 1);
    CHECK(strip.flipped > 0);
    CHECK(ring.one_sided_shells == 0);
    CHECK(ring.flipped == 0);
}
