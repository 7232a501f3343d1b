#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raw_mesh.hpp"
#include "surface_mesh.hpp"

namespace orbweaver::mesh {

inline constexpr std::size_t kMostEars = 4096;  ///< corners of a polygon that is cut ear by ear

/// Cuts a polygon into its corners - 2 triangles, wound as it is, and appends them (indices of `points`). Where
/// its first corner sees all of it, a fan about that corner; otherwise ears, the fattest first (Meisters 1975),
/// over its projection along Newell's normal. What crosses itself is cut as far as there are ears, the rest
/// into a fan. Throws Fault(limit) for a polygon that needs ears and has more than kMostEars corners: they take
/// quadratic time.
void triangulate(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                 std::vector<Triangle>& into);

}  // namespace orbweaver::mesh
