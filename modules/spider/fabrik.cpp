#include "fabrik.hpp"

#include <algorithm>
#include <array>

#include "half_jacobian.hpp"
#include "restarts.hpp"
#include "solvers.hpp"

namespace orbweaver::spider {

namespace {

// Its steps are cheap and gain little each.
constexpr double kFabrikGain = 0.99;
constexpr int kFabrikPatience = 5;

/// The unit vector from a to b.
Vec3 direction(const Vec3& a, const Vec3& b) noexcept {
    const double apart = distance(a, b);
    return apart > 0 ? (b - a) / apart : Vec3{1, 0, 0};
}

using Joints = std::array<Vec3, kBones + 1>;

Joints joints_in_plane(const Posture<double>& at) noexcept {
    Joints joints;
    for (std::size_t i = 0; i <= kBones; ++i) joints[i] = {at.x[i], at.y[i], 0};
    return joints;
}

/// Angles of the bones that point the way joints lie; each within its limits, if they are kept, and the next
/// bone seen from where that leaves it.
void follow(const Leg& leg, const Joints& joints, bool limited, LegPose& pose) noexcept {
    Rotor<double> before{1, 0};
    Vec3 from = joints[0];
    for (std::size_t i = 0; i < kBones; ++i) {
        const std::size_t j = kPitch + i;
        const Vec3 way = joints[i + 1] - from;
        const double angle =
            leg.bone[i] > 0 ? angle_of(before.c * way.x + before.s * way.y, before.c * way.y - before.s * way.x)
                            : 0;
        pose[j] = limited ? clamp(angle, leg.min[j], leg.max[j]) : angle;
        before = before * rotor(pose[j]);
        from += leg.bone[i] * Vec3{before.c, before.s, 0};
    }
}

/// Turns the plane towards the target and reaches within it, again and again.
Approach<double> fabrik_approach(const Leg& leg, const Vec3& target, bool limited,
                                 const LegSolverOptions& options, LegPose& pose) noexcept {
    const double enough = options.tolerance * options.tolerance;
    Approach<double> approach{1e300, 0};
    LegPose best = pose;
    int little_gains = 0;
    for (int step = 0;; ++step) {
        face(leg, target, foot_side(leg, pose), pose, limited);
        double angles[kJoints];
        std::copy(pose.begin(), pose.end(), angles);
        const Posture<double> at = posture(leg, angles);
        const Triple<double> aim = to_plane(at, Triple<double>{target.x, target.y, target.z});
        const Triple<double> error{aim.x - at.x[kBones], aim.y - at.y[kBones], aim.z};
        const double squared = dot(error, error);
        little_gains = squared > kFabrikGain * approach.squared_error ? little_gains + 1 : 0;
        if (squared < approach.squared_error) {
            approach.squared_error = squared;
            best = pose;
        }
        if (squared <= enough || little_gains >= kLittleGains || step == kFabrikPatience * options.max_steps)
            break;
        Joints joints = joints_in_plane(at);
        reach_back(joints, leg.bone, {aim.x, aim.y, 0});
        reach_out(joints, leg.bone, {});
        follow(leg, joints, limited, pose);
        approach.steps += 1;
    }
    pose = best;
    return approach;
}

LegResult solve(const Leg& leg, const LegTarget& target, bool limited, const LegSolverOptions& options,
                LegPose& pose) noexcept {
    const auto approach = [&](const Vec3& at, LegPose& from) {
        return fabrik_approach(leg, at, limited, options, from);
    };
    return solve_with_restarts(leg, target, options, approach, pose);
}

}  // namespace

void reach_back(std::span<Vec3> joints, std::span<const double> lengths, const Vec3& target) noexcept {
    joints.back() = target;
    for (std::size_t i = lengths.size(); i-- > 0;)
        joints[i] = joints[i + 1] + lengths[i] * direction(joints[i + 1], joints[i]);
}

void reach_out(std::span<Vec3> joints, std::span<const double> lengths, const Vec3& root) noexcept {
    joints.front() = root;
    for (std::size_t i = 0; i < lengths.size(); ++i)
        joints[i + 1] = joints[i] + lengths[i] * direction(joints[i], joints[i + 1]);
}

LegResult solve_fabrik(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                       LegPose& pose) {
    return solve(leg, target, true, options, pose);
}

LegResult solve_fabrik_unlimited(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                                 LegPose& pose) {
    return solve(leg, target, false, options, pose);
}

}  // namespace orbweaver::spider
