#include "friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::crawler {

namespace {

/// A part of a velocity over what resists it; nothing that moves needs no resistance.
double over(double part, double resistance) noexcept {
    if (part == 0) return 0;
    return resistance > 0 ? part / resistance : std::numeric_limits<double>::infinity();
}

/// The speed r at which a velocity ends that slides to an end under impulses a and b along its two parts:
///     (v_a / (r + a))^2 + (v_b / (r + b))^2 = 1.
/// The left side falls and is convex: Newton's method from below climbs to the root.
double end_speed(double va, double vb, double a, double b) noexcept {
    constexpr int kMost = 60;
    constexpr double kEnough = 1e-9;  // of r: the next step would change it by the square of that
    double r = std::max(0.0, std::sqrt(va * va + vb * vb) - std::max(a, b));
    if (a == 0) r = std::max(r, std::abs(va));
    if (b == 0) r = std::max(r, std::abs(vb));
    for (int i = 0; i < kMost; ++i) {
        const double p = over(va, r + a), q = over(vb, r + b);
        const double slope = 2 * (over(p * p, r + a) + over(q * q, r + b));
        const double next = r + (p * p + q * q - 1) / slope;
        const bool there = !(next > r * (1 + kEnough));
        r = std::max(r, next);
        if (there) break;
    }
    return r;
}

}  // namespace

Vec3 slide(const Friction& friction, double pressing, const Vec3& v, const Vec3& spine,
           const Vec3& side) noexcept {
    const double along = dot(v, spine), across = dot(v, side);
    if (friction.law == FrictionLaw::one_way) return along < 0 ? across * side : v;
    const double a = pressing * (along < 0 ? friction.backward : friction.forward);
    const double b = pressing * friction.sideways;
    const double p = over(along, a), q = over(across, b);
    if (p * p + q * q <= 1) return {};
    const double r = end_speed(along, across, a, b);
    return along * over(r, r + a) * spine + across * over(r, r + b) * side;
}

}  // namespace orbweaver::crawler
