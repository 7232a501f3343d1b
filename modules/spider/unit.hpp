#pragma once

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// The direction of v, or `otherwise` where it has none to speak of.
inline Vec3 unit_or(const Vec3& v, const Vec3& otherwise = {}) noexcept {
    constexpr double kLeast = 1e-9;
    const double length = norm(v);
    return length > kLeast ? v / length : otherwise;
}

}  // namespace orbweaver::spider
