#pragma once

#include <cmath>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// m, added to lengths before dividing: changes none that a body can have, and where ends meet, which gives no
/// direction, l * factor is zero and not a number divided by zero.
inline constexpr double kNoLength = 1e-150;

/// What a spring's pull is of its extent l = x_a - x_b: pull = factor * l, with
/// factor = [k (|l| - r) + c (dl/dt . l)/|l|]/|l| (thesis 4.14). `dl` is dl/dt.
inline double pull_factor(const Vec3& l, const Vec3& dl, double rest_length, double stiffness,
                          double damping) noexcept {
    const double length = std::sqrt(dot(l, l));
    const double inverse = 1 / (length + kNoLength);
    return (stiffness * (length - rest_length) + damping * dot(l, dl) * inverse) * inverse;
}

}  // namespace orbweaver::mass_spring
