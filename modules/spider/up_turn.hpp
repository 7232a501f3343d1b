#pragma once

#include <cstdint>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// How a turn runs in time: evenly, as a half wave of the cosine, or slowly at both ends (3 s^2 - 2 s^3).
enum class TurnCurve : std::uint8_t { linear, cosine, slow_in_slow_out };

/// A body's up on its way from one polygon's normal to another's. State of one creature.
struct UpTurn {
    Vec3 up{0, 1, 0};         ///< unit, now
    Vec3 from{0, 1, 0};       ///< unit, where the turn began
    Vec3 to{0, 1, 0};         ///< unit, where it ends
    std::uint32_t step = 0;   ///< of the turn, taken so far
    std::uint32_t steps = 0;  ///< of the turn in all; 0: there is none
};

/// Towards `wanted` (unit): where that is not what the turn under way leads to, a new one begins from the up of
/// now (ap Cenydd and Teahan 2005, 3.2), of `steps` steps or as many more as it takes to turn by no more than
/// `most_degrees` in each. Turns run along the great circle; where the ups are opposite, over `forward` (unit,
/// across up). One call is one step.
void turn_up(const Vec3& wanted, const Vec3& forward, TurnCurve curve, std::uint32_t steps, double most_degrees,
             UpTurn& turn) noexcept;

/// `from` (unit, across `up`), turned about `up` towards `to` (unit, the same) by no more than `most_degrees`;
/// right about, by the left.
Vec3 turned_about(const Vec3& up, const Vec3& from, const Vec3& to, double most_degrees) noexcept;

/// A body's forward (unit, across its up) after its up has gone from `before` to `after` (not opposite) on the
/// great circle: it did not turn about it.
Vec3 carried_over(const Vec3& forward, const Vec3& before, const Vec3& after) noexcept;

/// On the great circle from a to b (unit, not opposite), `share` of the angle on: of +, -, *, / and sqrt alone,
/// exact to 1e-14.
Vec3 turned_between(const Vec3& a, const Vec3& b, double share) noexcept;

/// Degrees between unit vectors, by the same means; at most 0.001 too many.
double degrees_between(const Vec3& a, const Vec3& b) noexcept;

}  // namespace orbweaver::spider
