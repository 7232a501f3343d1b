#pragma once

#include <cstdint>

#include "surface_mesh.hpp"

namespace orbweaver::mesh {

/// What was found in a mesh while it was built, and where first (kNone: nowhere). Baked files keep it.
struct Validation {
    std::uint64_t source_points = 0;
    std::uint64_t source_polygons = 0;
    std::uint64_t welded_points = 0;       ///< points that lay where another was
    std::uint64_t unused_points = 0;       ///< places that no triangle needs
    std::uint64_t dropped_degenerate = 0;  ///< triangles without area
    std::uint64_t dropped_duplicate =
        0;  ///< triangles over the same three vertices as one before, either way round
    std::uint64_t edges = 0;
    std::uint64_t border_edges = 0;          ///< of one face
    std::uint64_t nonmanifold_edges = 0;     ///< of more than two faces
    std::uint64_t nonmanifold_vertices = 0;  ///< where surfaces touch that no edge joins there, as in a bow-tie
    std::uint64_t t_junctions = 0;           ///< vertices on borders that lie on another border edge
    std::uint64_t shells = 0;
    std::uint64_t one_sided_shells = 0;              ///< that cannot be wound consistently, as a Moebius strip
    std::uint64_t flipped = 0;                       ///< triangles wound against the most of their shell
    std::uint32_t first_degenerate = kNone;          ///< source polygon
    std::uint32_t first_duplicate = kNone;           ///< source polygon
    std::uint32_t first_border = kNone;              ///< triangle
    std::uint32_t first_nonmanifold = kNone;         ///< triangle
    std::uint32_t first_nonmanifold_vertex = kNone;  ///< vertex
    std::uint32_t first_flipped = kNone;             ///< triangle
    std::uint32_t first_t_junction = kNone;          ///< vertex
    /// Source polygons that the importer's precision may have misshaped: whoever imports says so.
    std::uint32_t rounded_polygons = 0;

    friend bool operator==(const Validation&, const Validation&) = default;
};
static_assert(sizeof(Validation) == 14 * 8 + 8 * 4);

/// Counts vertices whose triangles are held together at them by more than one bundle of edges.
void find_nonmanifold_vertices(const SurfaceMesh& mesh, Validation& into);

}  // namespace orbweaver::mesh
