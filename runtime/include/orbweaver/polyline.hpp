#pragma once

#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A point further on along a line.
struct PointAhead {
    Vec3 point;           ///< m
    bool is_end = false;  ///< the line ends there, before it got so far
};

/// `ahead` (m) on along a line through `points` (m, at least one) from where that is nearest to `position`;
/// from the last point on to the first where it is a `loop`, any number of times round.
PointAhead ahead_on(std::span<const Vec3> points, bool loop, const Vec3& position, double ahead) noexcept;

}  // namespace orbweaver
