#pragma once

#include <cstdint>

#include "mass_spring/lanes.hpp"

namespace orbweaver::crawler {

/// How a body slides. `one_way` is Miller's (1988): what slides backwards is stopped, all else is free.
enum class FrictionLaw : std::uint8_t { coulomb, one_way };

struct Friction {
    FrictionLaw law = FrictionLaw::coulomb;
    double forward = 0.3, backward = 0.3, sideways = 0.3;  ///< coefficients, 1
    double adhesion = 0;  ///< m/s^2, that a point bears to be torn from the ground with
};

/// Velocities along a surface, m/s, by their parts along a body and across it; four at once.
struct Sliding {
    Lanes along, across;
};

/// The larger of each pair, without a comparison of what is no number.
ORBWEAVER_INLINE Lanes larger_of(const Lanes& a, const Lanes& b) noexcept { return a > b ? a : b; }
ORBWEAVER_INLINE bool is_any(const LaneBits& mask) noexcept {
    return ((mask[0] | mask[1]) | (mask[2] | mask[3])) != 0;
}

/// The speed r at which velocities end that slide to an end under impulses a and b along their parts:
///     (v_a / (r + a))^2 + (v_b / (r + b))^2 = 1.
/// The left side falls and is convex: Newton's method climbs to the root from below, and gets below it in one
/// step from where the impulses, weighed as the velocity lies, would lead. Means nothing where all comes
/// to rest.
ORBWEAVER_INLINE Lanes end_speed(const Sliding& v, const Lanes& a, const Lanes& b,
                                 const LaneBits& rests) noexcept {
    constexpr int kMost = 60;
    constexpr double kEnough = 1e-5;  // of r: the step after it would change r by the square of that
    constexpr double kLeast = 1e-12;  // of the speed, which r is never below
    const Lanes va = v.along * v.along, vb = v.across * v.across;
    const Lanes square = va + vb + 1e-300, speed = mass_spring::sqrt(square);
    const Lanes least = larger_of(larger_of(kLeast * speed, speed - larger_of(a, b)),
                                  larger_of(absolute(v.along) - a, absolute(v.across) - b));
    Lanes r = larger_of(least, speed - (a * va + b * vb) / square);
    bool goes_on = is_any(~rests);
    for (int i = 0; i < kMost && goes_on; ++i) {
        const Lanes both = 1 / ((r + a) * (r + b)), by_a = both * (r + b), by_b = both * (r + a);
        const Lanes p = va * by_a * by_a, q = vb * by_b * by_b;
        const Lanes change = (p + q - 1) / (2 * (p * by_a + q * by_b) + 1e-300);
        const Lanes next = larger_of(least, r + change);
        goes_on = is_any(~rests & (absolute(next - r) > kEnough * next));
        r = next;
    }
    return r;
}

/// After friction. `pressing`: m/s, >= 0, the velocity into the surface that the surface took.
///
/// Coulomb's friction on scales (Hu and Shelley 2012) bears mu_i u_i of the pressing along each axis, u =
/// v/|v|, with the coefficient of the way that it slides. It is taken at the end of the impulse, so that
/// nothing is turned round, and what the impulse can stop rests.
ORBWEAVER_INLINE Sliding slide(const Friction& friction, const Lanes& pressing, const Sliding& v) noexcept {
    if (friction.law == FrictionLaw::one_way) return {larger_of(v.along, Lanes{}), v.across};
    constexpr double kLeast = 1e-100;  // m/s, next to nothing, by which can be divided
    const Lanes forward = in_all(friction.forward), backward = in_all(friction.backward);
    const Lanes a = pressing * (v.along < 0 ? backward : forward) + kLeast,
                b = pressing * friction.sideways + kLeast;
    const Lanes p = v.along / a, q = v.across / b;
    const LaneBits rests = p * p + q * q <= in_all(1);
    const Lanes r = end_speed(v, a, b, rests);
    return {rests ? Lanes{} : v.along * (r / (r + a)), rests ? Lanes{} : v.across * (r / (r + b))};
}

}  // namespace orbweaver::crawler
