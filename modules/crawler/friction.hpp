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
ORBWEAVER_INLINE Lanes smaller_of(const Lanes& a, const Lanes& b) noexcept { return a < b ? a : b; }
ORBWEAVER_INLINE bool is_any(const LaneBits& mask) noexcept {
    return sign_bits(reinterpret_cast<Lanes>(mask)) != 0;
}

/// The power of two by which a number gets between 1 and 2.
ORBWEAVER_INLINE Lanes to_order_one(const Lanes& of) noexcept {
    constexpr std::int64_t kExponent = 0x7FF0000000000000, kOfTwo = 0x7FE0000000000000;
    return reinterpret_cast<Lanes>(kOfTwo - (reinterpret_cast<LaneBits>(of) & kExponent));
}

/// The speed r at which velocities end that slide to an end under impulses a and b along their parts:
///     S(r) = (v_a / (r + a))^2 + (v_b / (r + b))^2 = 1.
/// Newton's method for 1/sqrt(S) = 1, whose left side is concave and all but straight, so that after a step it
/// climbs to the root from below. With t = S - 1, sqrt(1 + t) - 1 is t/2 (1 + 11/12 t)/((1 + t)(1 + t/6)), or a
/// little more. All numbers are of the order of one, or limited; the result means nothing where all comes to
/// rest.
ORBWEAVER_INLINE Lanes end_speed(const Sliding& v, const Lanes& a, const Lanes& b, const LaneBits& rests,
                                 const Lanes& expected) noexcept {
    constexpr int kAsARule = 2, kMost = 60;
    constexpr double kEnough = 3e-5;  // of r: the step after it would change r by less than the square of that
    constexpr double kLeast = 1e-12;
    const Lanes va = v.along * v.along, vb = v.across * v.across;
    const Lanes along = absolute(v.along), across = absolute(v.across);
    // A speed is more than that along any direction.
    const Lanes halfway = 0.9238 * larger_of(along, across) + 0.3826 * smaller_of(along, across);
    const Lanes least =
        larger_of(larger_of(in_all(kLeast), halfway - larger_of(a, b)), larger_of(along - a, across - b));
    Lanes r = larger_of(least, smaller_of(expected, along + across)), change;
    const auto climb = [&]() ORBWEAVER_ALWAYS_INLINE {
        const Lanes to_a = r + a, to_b = r + b, a2 = to_a * to_a, b2 = to_b * to_b;
        const Lanes both = to_a * to_b, both2 = both * both;
        const Lanes excess = va * b2 + vb * a2 - both2;  // t, times both2
        const Lanes slope = va * b2 * to_b + vb * a2 * to_a;
        const Lanes next = larger_of(
            least, r + excess * (both2 + 11.0 / 12 * excess) * both / ((2 * both2 + 1.0 / 3 * excess) * slope));
        change = next - r;
        r = next;
    };
    for (int i = 0; i < kAsARule; ++i) climb();
    for (int i = kAsARule; i < kMost && is_any(~rests & (absolute(change) > kEnough * r)); ++i) climb();
    return r;
}

/// After friction. `pressing`: m/s, >= 0, the velocity into the surface that the surface took.
///
/// Coulomb's friction on scales (Hu and Shelley 2012) bears mu_i u_i of the pressing along each axis, u =
/// v/|v|, with the coefficient of the way that it slides. It is taken at the end of the impulse, so that
/// nothing is turned round, and what the impulse can stop rests. `expected`: m/s, a speed that may be near the
/// one that it ends with.
ORBWEAVER_INLINE Sliding slide(const Friction& friction, const Lanes& pressing, const Sliding& v,
                               const Lanes& expected) noexcept {
    if (friction.law == FrictionLaw::one_way) return {larger_of(v.along, Lanes{}), v.across};
    // Beyond a limit an impulse might as well be nothing, or endless.
    constexpr double kLimit = 1e30;
    const Lanes scale = to_order_one(larger_of(absolute(v.along), absolute(v.across)));
    const Sliding scaled{v.along * scale, v.across * scale};
    const auto impulse = [&](const Lanes& coefficient) ORBWEAVER_ALWAYS_INLINE {
        return smaller_of(in_all(kLimit), larger_of(in_all(1 / kLimit), pressing * coefficient * scale));
    };
    const Lanes a = impulse(v.along < 0 ? in_all(friction.backward) : in_all(friction.forward)),
                b = impulse(in_all(friction.sideways));
    const Lanes p = scaled.along * b, q = scaled.across * a, both = a * b;
    const LaneBits rests = p * p + q * q <= both * both;
    if (!is_any(~rests)) return {Lanes{}, Lanes{}};
    const Lanes r = end_speed(scaled, a, b, rests, expected * scale);
    return {rests ? Lanes{} : v.along * (r / (r + a)), rests ? Lanes{} : v.across * (r / (r + b))};
}

}  // namespace orbweaver::crawler
