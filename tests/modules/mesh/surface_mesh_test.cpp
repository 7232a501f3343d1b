#include "surface_mesh.hpp"

#include <catch2/catch.hpp>

#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

TEST_CASE("a code holds triangle, edge and parity up to the largest mesh", "[unit]") {
    for (const std::uint32_t triangle : {0u, 5u, kMostTriangles - 1})
        for (const std::uint32_t edge : {0u, 1u, 2u})
            for (const bool flipped : {false, true}) {
                const std::uint32_t code = across_code(triangle, edge, flipped);
                CHECK(is_neighbour(code));
                CHECK(across_triangle(code) == triangle);
                CHECK(across_edge(code) == edge);
                CHECK(is_flipped(code) == flipped);
            }
    CHECK_FALSE(is_neighbour(kBorder));
    CHECK_FALSE(is_neighbour(kNonManifold));
}

TEST_CASE("every face of an edge of many finds all faces of that edge", "[unit]") {
    const SurfaceMeshData data = test::build(fan(1, 4));
    const SurfaceMesh mesh = data.view();
    std::size_t asked = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) {
            const auto faces = fan_at(mesh, t, e);
            if (mesh.across[t][e] != kNonManifold) {
                CHECK(faces.empty());
                continue;
            }
            ++asked;
            REQUIRE(faces.size() == 3);
            CHECK(std::count(faces.begin(), faces.end(), 4 * t + e) == 1);
            for (const std::uint32_t face : faces) CHECK(mesh.across[face / 4][face % 4] == kNonManifold);
        }
    CHECK(asked == 3 * 4);
}

TEST_CASE("materials are found by number, and there is none beyond the last", "[unit]") {
    SurfaceMeshData data;
    for (const char c : {'a', 'b', '\0', '\0', 'c', '\0'}) data.material_names.push_back(c);
    const SurfaceMesh mesh = data.view();
    CHECK(material_name(mesh, 0) == "ab");
    CHECK(material_name(mesh, 1).empty());
    CHECK(material_name(mesh, 2) == "c");
    CHECK(material_name(mesh, 3).empty());
    CHECK(material_name(SurfaceMeshData{}.view(), 0).empty());
}
