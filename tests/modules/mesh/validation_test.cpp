#include "validation.hpp"

#include <catch2/catch.hpp>

#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

TEST_CASE("a vertex where two surfaces only touch is not manifold", "[unit]") {
    const Validation tie = test::validation_of(bow_tie(1, 3));
    CHECK(tie.nonmanifold_vertices == 1);
    CHECK(tie.first_nonmanifold_vertex == 0);
    CHECK(tie.shells == 2);
    // Two closed pyramids tip to tip: as many edges as faces at the tip, and still two surfaces.
    const RawMesh pyramids = test::raw_mesh(
        {{0, 0, 0}, {1, -1, 0}, {-1, -1, 1}, {-1, -1, -1}, {1, 1, 0}, {-1, 1, 1}, {-1, 1, -1}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}, {4, 5, 6}});
    CHECK(test::validation_of(pyramids).nonmanifold_vertices == 1);
    CHECK(test::validation_of(pyramids).border_edges == 0);
}

TEST_CASE("vertices of closed surfaces, of borders and of edges of three faces are manifold or held together",
          "[unit]") {
    for (const auto& raw : {cube(1, 2), sphere(1, 3), height_field(1, 4), moebius_strip(1, 2), fan(1, 3)})
        CHECK(test::validation_of(raw).nonmanifold_vertices == 0);
}
