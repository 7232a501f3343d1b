#pragma once

#include "aim.hpp"

namespace orbweaver::spider {

/// Poses and how far each is from what is asked (squared, leg lengths).
struct BestPose {
    LegPose pose;
    double squared_error;
    int steps;
    int restarts = 0;
};

/// Tries further starts until one is within tolerance. `approach(pose)` moves a pose and gives its Approach.
template <class Approaching>
void restart(const Leg& leg, const Vec3& target, const LegSolverOptions& options, const Approaching& approach,
             BestPose& best) noexcept {
    const double enough = options.tolerance * options.tolerance;
    while (best.restarts < options.restarts && !(best.squared_error <= enough)) {
        LegPose pose = start_pose(leg, target, best.restarts++);
        const auto end = approach(pose);
        best.steps += static_cast<int>(end.steps);
        if (!(end.squared_error < best.squared_error)) continue;
        best.squared_error = end.squared_error;
        best.pose = pose;
    }
}

inline LegResult result_of(const Leg& leg, const BestPose& best, bool beyond, double tolerance) noexcept {
    const bool reached = best.squared_error <= tolerance * tolerance;
    return {beyond    ? LegAnswer::out_of_reach
            : reached ? LegAnswer::reached
                      : LegAnswer::blocked,
            leg.length * sqrt(best.squared_error), best.steps, best.restarts};
}

/// `approach(target, pose)` from the given pose, and from others where that leads nowhere; the target being the
/// position in leg lengths. A target beyond reach is stretched towards once.
template <class Approaching>
LegResult solve_with_restarts(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                              const Approaching& approach, LegPose& pose) noexcept {
    const Vec3& p = target.position;
    const Aim<double> aim = aim_at(leg, Triple<double>{p.x, p.y, p.z});
    if (!aim.finite) return {};
    const Vec3 at{aim.at.x, aim.at.y, aim.at.z};
    const auto from = [&](LegPose& start) { return approach(at, start); };
    const auto first = from(pose);
    BestPose best{pose, first.squared_error, static_cast<int>(first.steps)};
    if (!aim.beyond) restart(leg, at, options, from, best);
    pose = best.pose;
    return result_of(leg, best, aim.beyond, options.tolerance);
}

}  // namespace orbweaver::spider
