#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "adjacency.hpp"

namespace orbweaver::mesh {

/// What edges hold together, and how it is wound.
struct Shells {
    std::vector<std::uint32_t> shell;  ///< one a triangle
    std::uint32_t count = 0;
    std::uint32_t one_sided = 0;          ///< shells that cannot be wound consistently
    std::uint64_t flipped = 0;            ///< triangles wound against the most of their shell
    std::uint32_t first_flipped = kNone;  ///< the lowest such triangle
};

/// Shells are numbered by their lowest triangle. Edges of more than two faces hold together, but say nothing of
/// winding.
Shells find_shells(std::span<const Triangle> triangles, const Adjacency& adjacency);

}  // namespace orbweaver::mesh
