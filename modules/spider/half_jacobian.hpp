#pragma once

#include "comfort.hpp"
#include "definite_system.hpp"
#include "leg_solver.hpp"
#include "posture.hpp"

namespace orbweaver::spider {

/// A step gains little when it leaves more than this share of the squared error; that often in a row is the
/// end.
inline constexpr double kLittleGain = 0.9;
inline constexpr int kLittleGains = 4;

/// What keeps the normal equations definite where the leg is straight, leg lengths squared per rad squared.
inline constexpr double kLeastDamping = 1e-8;

/// The turns by which joints answer to `error` (in the plane's frame, leg lengths) and to `wish` (rad):
///
///     dq = wish + W J^T y,   (J W J^T + lambda^2 1) y = error - J wish,   lambda^2 = |error|^2 / 2 + least
///
/// J: 3 x 8, how the foot moves. W: compliances. Wishes pass where they do not move the foot: in J's null
/// space. Damping by the error itself: Sugihara (2011); weights against limits: Chan and Dubey (1995).
template <class Real>
ORBWEAVER_INLINE void half_jacobian_turns(const Chain<Real>& leg, const Posture<Real>& at,
                                          const Real (&pose)[kJoints], const Triple<Real>& error,
                                          const Real& squared_error, const Real (&wish)[kJoints],
                                          Real (&turns)[kJoints]) noexcept {
    // Columns of the plane's joints have no z, and tilt's has nothing else.
    const Real x = at.x[kBones], y = at.y[kBones];
    const Triple<Real> yaw = foot_velocity(at, kYaw);
    const Real yaw_weight = compliance(leg, kYaw, pose[kYaw], dot(yaw, error));
    const Real tilt_weight = compliance(leg, kTilt, pose[kTilt], Real(y * error.z));
    const Triple<Real> weighted_yaw{yaw_weight * yaw.x, yaw_weight * yaw.y, yaw_weight * yaw.z};
    const Real damping = 0.5 * squared_error + kLeastDamping;
    Real a[3][3];
    a[0][0] = damping + weighted_yaw.x * yaw.x;
    a[1][0] = weighted_yaw.x * yaw.y;
    a[1][1] = damping + weighted_yaw.y * yaw.y;
    a[2][0] = weighted_yaw.x * yaw.z;
    a[2][1] = weighted_yaw.y * yaw.z;
    a[2][2] = damping + weighted_yaw.z * yaw.z + tilt_weight * y * y;
    Real b[3];
    b[0] = error.x - yaw.x * wish[kYaw];
    b[1] = error.y - yaw.y * wish[kYaw];
    b[2] = error.z - yaw.z * wish[kYaw] - y * wish[kTilt];
    Real move_x[kBones], move_y[kBones], weight[kBones];
    for (std::size_t i = 0; i < kBones; ++i) {
        const std::size_t j = kPitch + i;
        move_x[i] = at.y[i] - y;
        move_y[i] = x - at.x[i];
        weight[i] = compliance(leg, j, pose[j], Real(move_x[i] * error.x + move_y[i] * error.y));
        a[0][0] += weight[i] * move_x[i] * move_x[i];
        a[1][0] += weight[i] * move_x[i] * move_y[i];
        a[1][1] += weight[i] * move_y[i] * move_y[i];
        b[0] -= move_x[i] * wish[j];
        b[1] -= move_y[i] * wish[j];
    }
    solve_definite(a, b);
    turns[kYaw] = wish[kYaw] + weighted_yaw.x * b[0] + weighted_yaw.y * b[1] + weighted_yaw.z * b[2];
    turns[kTilt] = wish[kTilt] + tilt_weight * y * b[2];
    for (std::size_t i = 0; i < kBones; ++i)
        turns[kPitch + i] = wish[kPitch + i] + weight[i] * (move_x[i] * b[0] + move_y[i] * b[1]);
}

/// Turns joints, by at most max_turn, where `active`; none leaves its limits. `turns` becomes what they did.
template <class Real>
ORBWEAVER_INLINE void turn_joints(const Chain<Real>& leg, double max_turn, const Mask<Real>& active,
                                  Real (&turns)[kJoints], Real (&pose)[kJoints]) noexcept {
    Real largest = Real{} + max_turn;
    for (std::size_t j = 0; j < kJoints; ++j) largest = larger(largest, magnitude(turns[j]));
    const Real scale = max_turn / largest;
    for (std::size_t j = 0; j < kJoints; ++j) {
        const Real wanted = clamp(Real(pose[j] + scale * turns[j]), leg.min[j], leg.max[j]);
        const Real angle = select(active, wanted, pose[j]);
        turns[j] = angle - pose[j];
        pose[j] = angle;
    }
}

/// The square of the second-order part of what turns do to the foot is at most this, leg lengths: no second
/// derivative of the foot's place is longer than the leg.
template <class Real>
ORBWEAVER_INLINE Real squared_curvature(const Real (&turns)[kJoints]) noexcept {
    Real sum{};
    for (std::size_t j = 0; j < kJoints; ++j) sum += magnitude(turns[j]);
    const Real half_square = 0.5 * sum * sum;
    return half_square * half_square;
}

/// The square of what turns leave of `error`, to first order.
template <class Real>
ORBWEAVER_INLINE Real squared_rest(const Posture<Real>& at, const Triple<Real>& error,
                                   const Real (&turns)[kJoints]) noexcept {
    const Real x = at.x[kBones], y = at.y[kBones];
    const Triple<Real> yaw = foot_velocity(at, kYaw);
    Triple<Real> rest{error.x - yaw.x * turns[kYaw], error.y - yaw.y * turns[kYaw],
                      error.z - yaw.z * turns[kYaw] - y * turns[kTilt]};
    for (std::size_t i = 0; i < kBones; ++i) {
        rest.x -= (at.y[i] - y) * turns[kPitch + i];
        rest.y -= (x - at.x[i]) * turns[kPitch + i];
    }
    return dot(rest, rest);
}

/// Where the search from one start ended.
template <class Real>
struct Approach {
    Real squared_error;  ///< leg lengths squared; where within tolerance, it is no larger than this
    Real steps;
};

/// Steps from `pose` towards `target` (the leg's frame, leg lengths) where `active`, until within tolerance,
/// or nothing is gained any more. The first step also goes for comfort.
template <class Real>
ORBWEAVER_INLINE Approach<Real> half_jacobian_approach(const Chain<Real>& leg, const Triple<Real>& target,
                                                       const LegSolverOptions& options, Mask<Real> active,
                                                       Real (&pose)[kJoints]) noexcept {
    const double enough = options.tolerance * options.tolerance;
    const Real zero{};
    Approach<Real> approach{zero + 1e300, zero};
    Real little_gains = zero;
    Real wish[kJoints];
    for (std::size_t j = 0; j < kJoints; ++j)
        wish[j] = comfort_wish(leg, j, pose[j], options.comfort, options.rest);
    for (int step = 0;; ++step) {
        const Posture<Real> at = posture(leg, pose);
        const Triple<Real> aim = to_plane(at, target);
        const Triple<Real> error{aim.x - at.x[kBones], aim.y - at.y[kBones], aim.z};
        const Real squared = dot(error, error);
        little_gains = select(squared > kLittleGain * approach.squared_error, Real(little_gains + 1), zero);
        approach.squared_error = select(active, squared, approach.squared_error);
        const Real to_gain = select(little_gains < kLittleGains, squared, zero);
        if (step > 0) active = active & (to_gain > enough);
        if (step == options.max_steps || !any<Real>(active)) return approach;
        Real turns[kJoints];
        half_jacobian_turns(leg, at, pose, error, squared, wish, turns);
        turn_joints(leg, options.max_turn, active, turns, pose);
        approach.steps = select(active, Real(approach.steps + 1), approach.steps);
        // Where the step is sure to have been the last, nobody needs to look.
        const Real curvature = squared_curvature(turns);
        if (any<Real>(active & (2 * curvature <= enough))) {
            const Real bound = 2 * (squared_rest(at, error, turns) + curvature);  // (a + b)^2 <= 2 (a^2 + b^2)
            const Mask<Real> sure = active & (bound <= enough);
            approach.squared_error = select(sure, bound, approach.squared_error);
            active = active & (bound > enough);
            if (!any<Real>(active)) return approach;
        }
        for (Real& each : wish) each = zero;
    }
}

/// For one leg; `target` in leg lengths.
Approach<double> approach_by_half_jacobian(const Leg& leg, const Vec3& target, const LegSolverOptions& options,
                                           LegPose& pose) noexcept;

}  // namespace orbweaver::spider
