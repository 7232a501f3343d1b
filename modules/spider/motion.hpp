#pragma once

#include <cstdint>
#include <string_view>

#include "steering.hpp"

namespace orbweaver::spider {

/// How a point mass moves under v' = control(v), x' = v, for as long as what it wants stays the same. Euler's
/// is the paper's: v += a dt, x += v dt.
enum class MotionMethod : std::uint8_t { euler, midpoint, rk4 };

/// "euler", "midpoint", "rk4".
MotionMethod find_motion_method(std::string_view name) noexcept;

/// After one step: its velocity, and the one that led it there.
struct Motion {
    Vec3 velocity;  ///< m/s, across the agent's up, no faster than its top speed
    Vec3 way;       ///< m/s, the same: it has moved by that times dt
};

/// dt s of an agent that wants that velocity (m/s); see control() for `response` (s) and `strength` (m/s^2). Of
/// order 1, 2 and 4 where neither strength nor top speed bounds it.
Motion moved(MotionMethod method, const Agent& agent, const Vec3& wanted, double response, double strength,
             double dt) noexcept;

}  // namespace orbweaver::spider
