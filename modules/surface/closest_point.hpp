#pragma once

#include "triangle_set.hpp"

namespace orbweaver::surface {

/// Weights of the point of triangle `p` that is nearest to `q` (Ericson 2005, 5.1.5).
std::array<double, 3> closest_weights(const std::array<Vec3, 3>& p, const Vec3& q) noexcept;

}  // namespace orbweaver::surface
