#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface_mesh.hpp"

namespace orbweaver::mesh {

/// Who is next to whom, in the form that SurfaceMesh keeps.
struct Adjacency {
    std::vector<Triangle> across;
    std::vector<std::uint32_t> ring_first;
    std::vector<std::uint32_t> ring;
    std::vector<std::uint32_t> fan_first;
    std::vector<std::uint32_t> fan;
    std::uint64_t edges = 0;
    std::uint64_t border_edges = 0;

    std::uint64_t nonmanifold_edges() const noexcept { return fan_first.size() - 1; }
};

/// Pairs the half-edges of triangles that have three different vertices below `vertex_count` each. Linear in
/// the triangles, but for vertices of very many edges.
Adjacency build_adjacency(std::span<const Triangle> triangles, std::uint32_t vertex_count);

}  // namespace orbweaver::mesh
