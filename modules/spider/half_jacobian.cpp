#include "half_jacobian.hpp"

#include <algorithm>

#include "restarts.hpp"
#include "solvers.hpp"

namespace orbweaver::spider {

Approach<double> approach_by_half_jacobian(const Leg& leg, const Vec3& target, const LegSolverOptions& options,
                                           LegPose& pose) noexcept {
    double angles[kJoints];
    std::copy(pose.begin(), pose.end(), angles);
    const Triple<double> at{target.x, target.y, target.z};
    const Approach<double> end = half_jacobian_approach(leg, at, options, true, angles);
    std::copy(std::begin(angles), std::end(angles), pose.begin());
    return end;
}

LegResult solve_half_jacobian(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                              LegPose& pose) {
    const auto approach = [&](const Vec3& at, LegPose& from) {
        return approach_by_half_jacobian(leg, at, options, from);
    };
    return solve_with_restarts(leg, target, options, approach, pose);
}

}  // namespace orbweaver::spider
