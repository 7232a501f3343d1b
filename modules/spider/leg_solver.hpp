#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "leg.hpp"

namespace orbweaver::spider {

/// Where a foot should be, in the leg's frame, m; and how its last bone should lie, which only solvers that
/// ask for an orientation look at (unit vectors at right angles).
struct LegTarget {
    Vec3 position;
    Frame orientation{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

enum class LegAnswer : std::uint8_t {
    reached,       ///< within tolerance
    out_of_reach,  ///< further away than the leg is long: stretched towards it
    blocked,       ///< joint limits are in the way: the nearest pose that was found
    refused,       ///< the target is not finite: the pose was kept
};

struct LegResult {
    LegAnswer answer = LegAnswer::refused;
    /// m, between the foot and the target; when out of reach, the point on the way to it that the leg is long.
    /// When reached, it may be a bound that is larger. Of a solver that orients, a radian counts as a leg's
    /// length.
    double error = 0;
    int steps = 0;     ///< in all
    int restarts = 0;  ///< starts after the one from the given pose
};

struct LegSolverOptions {
    double tolerance = 1e-6;  ///< of the leg's length; of an orientation, rad
    double comfort = 0.2;     ///< share of the way back into comfort that one call goes, where the foot lets it
    double rest = 0.02;       ///< likewise of the way to the rest pose
    double max_turn = 0.5;    ///< rad, of any joint in one step
    int max_steps = 30;       ///< from each start
    int restarts = 8;         ///< starts from other poses when the given one leads nowhere: see start_pose()
};

/// Moves `pose`, which is within limits and stays so, until the foot is at the target. Poses go in warm: the
/// nearer the foot, the fewer steps. Allocates nothing; the same bits on every machine.
using SolveLeg = LegResult (*)(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                               LegPose& pose);

struct LegSolver {
    std::string_view name;
    SolveLeg solve;
    bool orients;       ///< the last bone too
    bool keeps_limits;  ///< the pose is within limits, always
};

/// half_jacobian, full_jacobian, fabrik, fabrik_unlimited.
std::span<const LegSolver> leg_solvers() noexcept;

/// Null when there is none of that name.
const LegSolver* find_leg_solver(std::string_view name) noexcept;

}  // namespace orbweaver::spider
