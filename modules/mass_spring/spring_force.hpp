#pragma once

#include <algorithm>
#include <cmath>

#include "network.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// m, added to lengths before dividing: changes none that a body can have, and where ends meet, which gives no
/// direction, l * factor is zero and not a number divided by zero.
inline constexpr double kNoLength = 1e-150;

/// What a spring bears, and what a little more stretch adds to it.
struct Tension {
    double force = 0;  ///< T, N, negative in compression
    double slope = 0;  ///< dT/d|l|, N/m
};

/// Of a spring without its arm, stretched by `extension` m.
inline Tension tension_at(const Spring& s, double extension) noexcept {
    const double e = std::max(extension, 0.0);
    const double a = s.law.softening, b = s.law.stiffening;
    return {s.stiffness * extension * (1 + e * (b * e - a)), s.stiffness * (1 + e * (3 * b * e - 2 * a))};
}

/// J, of the same.
inline double elastic_energy(const Spring& s, double extension) noexcept {
    const double e = std::max(extension, 0.0);
    return s.stiffness * extension * extension * (0.5 + e * (s.law.stiffening / 4 * e - s.law.softening / 3));
}

/// N/m, the largest slope of a spring with its arm, of all lengths up to twice its rest length.
inline double largest_slope(const Spring& s) noexcept {
    return std::max(s.stiffness, tension_at(s, s.rest_length).slope) + s.law.arm;
}

/// What a spring's pull is of its extent l = x_a - x_b, `length` m long: pull = factor * l, with
/// factor = [T + c (dl/dt . l)/|l|]/|l| (thesis 4.14). `dl` is dl/dt.
inline double pull_factor(const Vec3& l, double length, const Vec3& dl, double tension,
                          double damping) noexcept {
    const double inverse = 1 / (length + kNoLength);
    return (tension + damping * dot(l, dl) * inverse) * inverse;
}

}  // namespace orbweaver::mass_spring
