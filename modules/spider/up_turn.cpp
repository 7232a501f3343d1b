#include "up_turn.hpp"

#include <algorithm>

#include "orbweaver/exact_math.hpp"
#include "rotor.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kSame = 1e-12;

Vec3 unit(const Vec3& v) noexcept { return v / norm(v); }

/// Between unit vectors that are not opposite.
Vec3 middle(const Vec3& a, const Vec3& b) noexcept { return unit(a + b); }

double eased(TurnCurve curve, double share) noexcept {
    switch (curve) {
        case TurnCurve::cosine:
            return (1 - cos_degrees(180 * share)) / 2;
        case TurnCurve::slow_in_slow_out:
            return share * share * (3 - 2 * share);
        case TurnCurve::linear:
            break;
    }
    return share;
}

/// The most that a step of the curve does, times the number of steps.
double steepest(TurnCurve curve) noexcept {
    return curve == TurnCurve::linear ? 1 : curve == TurnCurve::cosine ? kPi / 2 : 1.5;
}

bool is_opposite(const Vec3& a, const Vec3& b) noexcept { return norm(a + b) < 1e-6; }

Vec3 on_the_way(const UpTurn& turn, const Vec3& forward, double share) noexcept {
    if (!is_opposite(turn.from, turn.to)) return turned_between(turn.from, turn.to, share);
    const Vec3 ahead = unit(forward - dot(forward, turn.from) * turn.from);
    return share < 0.5 ? turned_between(turn.from, ahead, 2 * share)
                       : turned_between(ahead, turn.to, 2 * share - 1);
}

}  // namespace

double degrees_between(const Vec3& a, const Vec3& b) noexcept {
    if (dot(a, b) < 0) return is_opposite(a, b) ? 180 : 2 * degrees_between(a, middle(a, b));
    const Vec3 quarter = middle(a, middle(a, b));
    const double chord = distance(a, quarter);  // of at most 22.5 degrees
    const double square = chord * chord;
    return 4 / kDegree * chord * (1 + square * (1.0 / 24 + square * 0.0049));  // 2 asin(chord/2), from above
}

Vec3 turned_between(const Vec3& a, const Vec3& b, double share) noexcept {
    if (share <= 0 || a == b) return a;
    if (share >= 1) return b;
    // Across a, twice: what is left of b where the two are nearly opposite is mostly rounding.
    const Vec3 aside = across(across(b, a), a);
    const double size = norm(aside);
    if (!(size > 0)) return a;
    const Rotor<double> turn = rotor(share * angle_of(dot(a, b), size));
    return unit(turn.c * a + (turn.s / size) * aside);
}

Vec3 turned_about(const Vec3& up, const Vec3& from, const Vec3& to, double most_degrees) noexcept {
    const Rotor<double> turn = rotor(kDegree * std::min(most_degrees, 180.0));
    if (dot(from, to) >= turn.c) return to;
    const Vec3 left = cross(up, from);
    return unit(turn.c * from + (dot(left, to) < 0 ? -turn.s : turn.s) * left);
}

Vec3 carried_over(const Vec3& forward, const Vec3& before, const Vec3& after) noexcept {
    const Vec3 turned = forward - (dot(forward, after) / (1 + dot(before, after))) * (before + after);
    return unit(across(turned, after));
}

void turn_up(const Vec3& wanted, const Vec3& forward, TurnCurve curve, std::uint32_t steps, double most_degrees,
             UpTurn& turn) noexcept {
    const bool leads_there = turn.steps > 0 && distance(turn.to, wanted) < kSame;
    if (!leads_there) {
        if (distance(turn.up, wanted) < kSame) {
            turn.steps = 0;
            return;
        }
        const double needed = degrees_between(turn.up, wanted) * steepest(curve) / most_degrees;
        constexpr double kMost = 4e9;  // slower than that is not at all
        turn.steps = 0;
        if (!(needed < kMost)) return;
        turn.from = turn.up;
        turn.to = wanted;
        turn.step = 0;
        turn.steps = std::max(steps, static_cast<std::uint32_t>(needed) + 1);
    }
    ++turn.step;
    if (turn.step >= turn.steps) {
        turn.up = turn.to;
        turn.steps = 0;
        return;
    }
    const double share = static_cast<double>(turn.step) / turn.steps;
    turn.up = on_the_way(turn, forward, eased(curve, share));
}

}  // namespace orbweaver::spider
