#include "adjacency.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

/// Every half-edge against every other: quadratic, and too simple to be wrong.
std::uint32_t across_by_search(std::span<const Triangle> triangles, std::uint32_t t, std::uint32_t e) {
    const std::uint32_t from = triangles[t][e], to = triangles[t][(e + 1) % 3];
    std::uint32_t found = kBorder;
    for (std::uint32_t other = 0; other < triangles.size(); ++other)
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t a = triangles[other][edge], b = triangles[other][(edge + 1) % 3];
            if (other == t || !((a == from && b == to) || (a == to && b == from))) continue;
            found = found == kBorder ? across_code(other, edge, a == from) : kNonManifold;
        }
    return found;
}

}  // namespace

TEST_CASE("what lies across each edge is what a search of all pairs finds", "[unit]") {
    for (const Shape& shape : shapes()) {
        INFO(shape.name);
        const SurfaceMeshData mesh = test::build(shape.make(1, 3));
        const Adjacency adjacency =
            build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.vertices.size()));
        std::size_t wrong = 0;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (std::uint32_t e = 0; e < 3; ++e)
                wrong += adjacency.across[t][e] != across_by_search(mesh.triangles, t, e);
        CHECK(wrong == 0);
    }
}

TEST_CASE("a ring holds the triangles at a vertex, in ascending order", "[unit]") {
    for (const Shape& shape : shapes()) {
        INFO(shape.name);
        const SurfaceMeshData data = test::build(shape.make(1, 2));
        const SurfaceMesh mesh = data.view();
        std::size_t wrong = 0;
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
                if (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), v) > 0)
                    expected.push_back(t);
            const auto ring = ring_at(mesh, v);
            wrong += !std::equal(ring.begin(), ring.end(), expected.begin(), expected.end());
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("two triangles wound alike meet unflipped, one turned over meets flipped", "[unit]") {
    const std::vector<Triangle> alike = {{0, 1, 2}, {0, 2, 3}};
    CHECK(build_adjacency(alike, 4).across[0] == Triangle{kBorder, kBorder, across_code(1, 0, false)});
    CHECK(build_adjacency(alike, 4).across[1] == Triangle{across_code(0, 2, false), kBorder, kBorder});
    const std::vector<Triangle> turned = {{0, 1, 2}, {0, 3, 2}};
    CHECK(build_adjacency(turned, 4).across[0] == Triangle{kBorder, kBorder, across_code(1, 2, true)});
    CHECK(build_adjacency(turned, 4).across[1] == Triangle{kBorder, kBorder, across_code(0, 2, true)});
}

TEST_CASE("an edge of three faces keeps all three", "[unit]") {
    const std::vector<Triangle> blades = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const Adjacency adjacency = build_adjacency(blades, 5);
    CHECK(adjacency.nonmanifold_edges() == 1);
    CHECK(adjacency.border_edges == 6);
    CHECK(adjacency.edges == 7);
    CHECK(adjacency.fan_first == std::vector<std::uint32_t>{0, 3});
    CHECK(adjacency.fan == std::vector<std::uint32_t>{0 * 4 + 0, 1 * 4 + 0, 2 * 4 + 0});
    for (const Triangle& codes : adjacency.across) CHECK(codes == Triangle{kNonManifold, kBorder, kBorder});
}

// An umbrella of 200,000 ribs: a search of each rib among all others would take hours.
TEST_CASE("a vertex of very many edges does not take quadratic time", "[unit]") {
    constexpr std::uint32_t kRibs = 200'000;
    std::vector<Triangle> umbrella;
    for (std::uint32_t i = 0; i < kRibs; ++i) umbrella.push_back({0, 1 + i, 1 + (i + 1) % kRibs});
    const Adjacency adjacency = build_adjacency(umbrella, kRibs + 1);
    CHECK(adjacency.border_edges == kRibs);
    CHECK(adjacency.edges == 2 * kRibs);
    CHECK(adjacency.across[7] == Triangle{across_code(6, 2, false), kBorder, across_code(8, 0, false)});
}
