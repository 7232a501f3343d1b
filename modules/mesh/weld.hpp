#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mesh {

/// For each point the first one that lies where it lies: itself, or an earlier one. With tolerance 0 (m)
/// "where" means equal coordinates (-0 is 0); otherwise within the tolerance of an earlier point that is its
/// own. Linear in the points, unless very many lie within one tolerance.
std::vector<std::uint32_t> weld(std::span<const Vec3> points, double tolerance = 0);

}  // namespace orbweaver::mesh
