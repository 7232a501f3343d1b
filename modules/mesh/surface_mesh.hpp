#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mesh {

using Triangle = std::array<std::uint32_t, 3>;  ///< three vertices, or a value for each of three edges

inline constexpr std::uint32_t kNone = 0xFFFFFFFF;    ///< no such element
inline constexpr std::uint32_t kBorder = 0xFFFFFFFF;  ///< across a border edge: nothing
inline constexpr std::uint32_t kNonManifold =
    0xFFFFFFFE;  ///< across an edge of more than two faces: see fan_at
inline constexpr std::uint32_t kMostTriangles = (1u << 29) - 2;

/// What lies across an edge, in one word: triangle * 8 + edge * 2 + flipped. `flipped`: the neighbour runs the
/// edge in the same direction, so its winding is opposed: what is outside here is inside there.
constexpr std::uint32_t across_code(std::uint32_t triangle, std::uint32_t edge, bool flipped) noexcept {
    return triangle * 8 + edge * 2 + (flipped ? 1u : 0u);
}
constexpr bool is_neighbour(std::uint32_t code) noexcept { return code < kNonManifold; }
constexpr std::uint32_t across_triangle(std::uint32_t code) noexcept { return code >> 3; }
constexpr std::uint32_t across_edge(std::uint32_t code) noexcept { return (code >> 1) & 3; }
constexpr bool is_flipped(std::uint32_t code) noexcept { return (code & 1) != 0; }

constexpr std::uint32_t next_corner(std::uint32_t corner) noexcept { return corner == 2 ? 0 : corner + 1; }

/// How a surface is to feet.
struct SurfaceProperty {
    double friction = 0.6;        ///< Coulomb coefficient, >= 0
    std::uint32_t climbable = 1;  ///< 0: feet find no hold where it is steep, as on glass
    std::uint32_t reserved = 0;
    friend bool operator==(const SurfaceProperty&, const SurfaceProperty&) = default;
};
static_assert(sizeof(SurfaceProperty) == 16);

struct Bounds {
    Vec3 min;  ///< m
    Vec3 max;  ///< m
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Triangles with their neighbours, ready to be walked on: a view of memory that somebody else keeps, such as a
/// mapped file or SurfaceMeshData. Edge e of a triangle runs from its corner e to its corner (e + 1) % 3.
struct SurfaceMesh {
    std::span<const Vec3> vertices;       ///< m; each is a corner of some triangle
    std::span<const Triangle> triangles;  ///< counter-clockwise from outside; in the order of their polygons
    std::span<const Triangle> across;     ///< one a triangle: a code for each edge, see across_code
    std::span<const std::uint32_t> ring_first;  ///< vertices + 1: where each vertex's part of `ring` begins
    std::span<const std::uint32_t> ring;        ///< triangles at each vertex, ascending
    std::span<const std::uint32_t>
        fan_first;  ///< edges of more than two faces, + 1: where each one's part of `fan` begins
    std::span<const std::uint32_t> fan;  ///< triangle * 4 + edge; the edges ascend by (lower, higher) vertex
    std::span<const std::uint32_t>
        polygon;  ///< one a triangle: the source's polygon that it is part of, ascending
    std::span<const std::uint32_t>
        shell;  ///< one a triangle: shells are what edges hold together, numbered from 0
    std::span<const std::uint16_t>
        property;  ///< one a triangle: index of `properties`, which is that of its material
    std::span<const SurfaceProperty> properties;
    std::span<const char> material_names;  ///< one a property, each ended by a zero
    Bounds bounds;

    const Vec3& corner(std::size_t triangle, std::size_t which) const noexcept {
        return vertices[triangles[triangle][which]];
    }
};

/// The triangles at a vertex.
inline std::span<const std::uint32_t> ring_at(const SurfaceMesh& mesh, std::size_t vertex) noexcept {
    return mesh.ring.subspan(mesh.ring_first[vertex], mesh.ring_first[vertex + 1] - mesh.ring_first[vertex]);
}

/// All faces (triangle * 4 + edge, ascending) of the edge that this edge of a triangle is; empty unless its
/// code is kNonManifold. A binary search.
std::span<const std::uint32_t> fan_at(const SurfaceMesh& mesh, std::uint32_t triangle,
                                      std::uint32_t edge) noexcept;

/// The name of a material; empty when there is none.
std::string_view material_name(const SurfaceMesh& mesh, std::size_t property) noexcept;

/// The same, owned.
struct SurfaceMeshData {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<Triangle> across;
    std::vector<std::uint32_t> ring_first;
    std::vector<std::uint32_t> ring;
    std::vector<std::uint32_t> fan_first;
    std::vector<std::uint32_t> fan;
    std::vector<std::uint32_t> polygon;
    std::vector<std::uint32_t> shell;
    std::vector<std::uint16_t> property;
    std::vector<SurfaceProperty> properties;
    std::vector<char> material_names;
    Bounds bounds;

    /// Valid while this lives and keeps its sizes.
    SurfaceMesh view() const noexcept;
};

}  // namespace orbweaver::mesh
