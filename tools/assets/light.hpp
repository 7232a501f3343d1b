#pragma once

#include <algorithm>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// Linear light: x red, y green, z blue.
using Light = Vec3;

inline Light mix(const Light& a, const Light& b, double t) { return a + (b - a) * t; }
inline Light times(const Light& a, const Light& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// 0 below `low`, 1 above `high`, smooth between.
inline double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace orbweaver
