#pragma once

#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// Forward and backward reaching (Aristidou and Lasenby 2011) of a chain of points: joints[i] and joints[i + 1]
/// are lengths[i] apart afterwards, to rounding. Where two points are the same, x is the way between them.

/// From the end, which goes to the target, to the root, which leaves its place.
void reach_back(std::span<Vec3> joints, std::span<const double> lengths, const Vec3& target) noexcept;

/// From the root, which goes back to its place, to the end.
void reach_out(std::span<Vec3> joints, std::span<const double> lengths, const Vec3& root) noexcept;

}  // namespace orbweaver::spider
