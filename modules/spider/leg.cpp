#include "leg.hpp"

#include <algorithm>

#include "posture.hpp"

namespace orbweaver::spider {

namespace {

Posture<double> posture_of(const Leg& leg, const LegPose& pose) noexcept {
    double angles[kJoints];
    std::copy(pose.begin(), pose.end(), angles);
    return posture(leg, angles);
}

Vec3 in_leg(const Posture<double>& at, const Triple<double>& v) noexcept {
    const Triple<double> turned = from_plane(at, v);
    return {turned.x, turned.y, turned.z};
}

double per(double width) noexcept { return width != 0 ? 1 / width : 0; }

}  // namespace

Leg make_leg(const std::array<double, kBones>& bones, const std::array<JointRange, kJoints>& joints) noexcept {
    Leg leg{};
    for (const double bone : bones) leg.length += bone;
    leg.per_length = 1 / leg.length;
    for (std::size_t i = 0; i < kBones; ++i) leg.bone[i] = bones[i] / leg.length;
    for (std::size_t j = 0; j < kJoints; ++j) {
        const JointRange& range = joints[j];
        leg.min[j] = range.min;
        leg.max[j] = range.max;
        leg.comfort_min[j] = range.comfort_min;
        leg.comfort_max[j] = range.comfort_max;
        leg.per_below[j] = per(range.min - range.comfort_min);
        leg.per_above[j] = per(range.max - range.comfort_max);
        leg.stiffness[j] = range.stiffness;
        leg.rest[j] = range.rest;
    }
    return leg;
}

LegPose rest_pose(const Leg& leg) noexcept {
    LegPose pose;
    std::copy(std::begin(leg.rest), std::end(leg.rest), pose.begin());
    return pose;
}

LegPose within_limits(const Leg& leg, const LegPose& pose) noexcept {
    LegPose legal;
    for (std::size_t j = 0; j < kJoints; ++j) legal[j] = clamp(pose[j], leg.min[j], leg.max[j]);
    return legal;
}

double violation(const Leg& leg, const LegPose& pose) noexcept {
    double most = 0;
    for (std::size_t j = 0; j < kJoints; ++j)
        most = std::max({most, pose[j] - leg.max[j], leg.min[j] - pose[j]});
    return most;
}

std::array<Vec3, kBones + 1> joint_positions(const Leg& leg, const LegPose& pose) noexcept {
    const Posture<double> at = posture_of(leg, pose);
    std::array<Vec3, kBones + 1> positions;
    for (std::size_t i = 0; i <= kBones; ++i) positions[i] = leg.length * in_leg(at, {at.x[i], at.y[i], 0});
    return positions;
}

Vec3 foot_position(const Leg& leg, const LegPose& pose) noexcept {
    const Posture<double> at = posture_of(leg, pose);
    return leg.length * in_leg(at, {at.x[kBones], at.y[kBones], 0});
}

Frame foot_frame(const Leg& leg, const LegPose& pose) noexcept {
    const Posture<double> at = posture_of(leg, pose);
    const Rotor<double>& tip = at.along[kBones - 1];
    return {in_leg(at, {tip.c, tip.s, 0}), in_leg(at, {-tip.s, tip.c, 0}), in_leg(at, {0, 0, 1})};
}

Jacobian jacobian(const Leg& leg, const LegPose& pose) noexcept {
    const Posture<double> at = posture_of(leg, pose);
    Jacobian columns;
    for (std::size_t j = 0; j < kJoints; ++j)
        columns[j] = {leg.length * in_leg(at, foot_velocity(at, j)), in_leg(at, joint_axis(at, j))};
    return columns;
}

}  // namespace orbweaver::spider
