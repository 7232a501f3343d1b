#include "half_jacobian.hpp"

#include <algorithm>

#include "restarts.hpp"
#include "solvers.hpp"

namespace orbweaver::spider {

LegResult solve_half_jacobian(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                              LegPose& pose) {
    const auto approach = [&](const Vec3& at, LegPose& from) {
        double angles[kJoints];
        std::copy(from.begin(), from.end(), angles);
        const auto end = half_jacobian_approach(leg, Triple<double>{at.x, at.y, at.z}, options, true, angles);
        std::copy(std::begin(angles), std::end(angles), from.begin());
        return end;
    };
    return solve_with_restarts(leg, target, options, approach, pose);
}

}  // namespace orbweaver::spider
