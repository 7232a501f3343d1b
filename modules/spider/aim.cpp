#include "aim.hpp"

#include <algorithm>
#include <array>

namespace orbweaver::spider {

namespace {

double into_turn(double angle) noexcept {
    if (angle > kPi) return angle - 2 * kPi;
    return angle < -kPi ? angle + 2 * kPi : angle;
}

/// Where the foot is in the plane, along x, leg lengths.
double planar_reach(const Leg& leg, const LegPose& pose) noexcept {
    double angles[kJoints];
    std::copy(pose.begin(), pose.end(), angles);
    return posture(leg, angles).x[kBones];
}

/// -1: the joint's least angle, 0: its rest, 1: its greatest.
double along(const Leg& leg, std::size_t j, double share) noexcept {
    const double end = share < 0 ? leg.min[j] : leg.max[j];
    return leg.rest[j] + magnitude(share) * (end - leg.rest[j]);
}

/// Of a start, as along() has it: pitch, the hinges of femur and patella, and those further out; and the side
/// of the root that faces the target.
struct Start {
    double pitch, near, far, side;
};
constexpr std::array<Start, 8> kStarts{{
    {0, 0, 0, 1},            // rest
    {0, -0.7, -0.7, -1},     // curled
    {0.8, 0.2, -0.9, 1},     // hooked
    {0.9, 0.9, 0.9, -1},     // over the body
    {0.7, -0.9, -0.9, -1},   // curled over
    {-0.7, -0.7, -0.7, -1},  // curled under
    {0, 0.7, 0.7, 1},        // stretched
    {0.7, -0.4, -0.4, 1},    // raised
}};

}  // namespace

Vec3 leg_lengths(const Leg& leg, const Vec3& position) noexcept {
    const Triple<double> at = aim_at(leg, Triple<double>{position.x, position.y, position.z}).at;
    return {at.x, at.y, at.z};
}

double foot_side(const Leg& leg, const LegPose& pose) noexcept { return planar_reach(leg, pose) < 0 ? -1 : 1; }

void face(const Leg& leg, const Vec3& target, double side, LegPose& pose, bool limited) noexcept {
    // The target as seen by a plane turned by yaw has to lie on z = y tan(tilt), on the foot's side of the
    // root.
    const Rotor<double> tilt = rotor(pose[kTilt]);
    const double level = sqrt(target.x * target.x + target.z * target.z);
    if (!(level > 0)) return;
    const double heading = angle_of(side * target.x, -side * target.z);
    const double wanted = side * target.y * tilt.s / (tilt.c * level);
    const double s = clamp(wanted, -1.0, 1.0);
    const double turn = into_turn(heading + angle_of(sqrt(1 - s * s), s));
    pose[kYaw] = limited ? clamp(turn, leg.min[kYaw], leg.max[kYaw]) : turn;
    if (pose[kYaw] == turn && s == wanted) return;
    const Rotor<double> yaw = rotor(pose[kYaw]);
    const double across = yaw.s * target.x + yaw.c * target.z;
    const double angle = target.y < 0 ? angle_of(-target.y, -across) : angle_of(target.y, across);
    pose[kTilt] = limited ? clamp(angle, leg.min[kTilt], leg.max[kTilt]) : angle;
}

LegPose start_pose(const Leg& leg, const Vec3& target, int start) noexcept {
    const Start& from = kStarts[static_cast<std::size_t>(start) % kStarts.size()];
    LegPose pose = rest_pose(leg);
    pose[kPitch] = along(leg, kPitch, from.pitch);
    for (std::size_t j = kPitch + 1; j < kJoints; ++j)
        pose[j] = along(leg, j, j <= kPitch + 2 ? from.near : from.far);
    face(leg, target, from.side, pose);
    return pose;
}

}  // namespace orbweaver::spider
