#pragma once

#include <array>
#include <cstddef>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// A leg is a plane that stands on the body, and a chain of bones in it.
///
/// Frame of a leg: its root is the origin, x points out of the body along the leg's heading, y up, z = x * y.
/// The plane is turned about y (yaw), then tilted about its own x (tilt). Bones turn in it, about its own z:
/// the first one by pitch against x, each further one by its hinge against the one before; up is positive.
/// Yaw, tilt and pitch are the three degrees of the ball joint.

inline constexpr std::size_t kBones = 6;   ///< coxa, femur, patella, tibia, metatarsus, tarsus
inline constexpr std::size_t kJoints = 8;  ///< yaw, tilt, pitch, and five hinges
inline constexpr std::size_t kYaw = 0;
inline constexpr std::size_t kTilt = 1;
inline constexpr std::size_t kPitch = 2;  ///< the first of kBones angles in the plane

inline constexpr std::array<const char*, kBones> kBoneNames{"coxa",  "femur",      "patella",
                                                            "tibia", "metatarsus", "tarsus"};
inline constexpr std::array<const char*, kJoints> kJointNames{
    "yaw",     "tilt",  "pitch",      "femur",
    "patella", "tibia", "metatarsus", "tarsus"};  ///< hinges: by what they turn

/// Angles, rad, in the order of kJointNames.
using LegPose = std::array<double, kJoints>;

/// How far a joint turns, rad: min <= comfort_min <= comfort_max <= max, within [-pi, pi].
struct JointRange {
    double min = 0;
    double max = 0;
    double comfort_min = 0;
    double comfort_max = 0;
    double stiffness = 0;  ///< 1; how early resistance grows beyond comfort, 0 to 1 (see compliance())
    double rest = 0;       ///< within comfort
};

/// Of one leg (Real a double) or of several (lanes), in the order of kBoneNames and kJointNames. Constant.
/// Aligned as code for wide registers takes it to be; on its own, plain code asks for less.
template <class Real>
struct alignas(sizeof(Real)) Chain {
    Real length;                ///< m, of all bones
    Real per_length;            ///< 1/m
    Real bone[kBones];          ///< as a share of length; a bone that the leg lacks has 0
    Real min[kJoints];          ///< rad; a joint that the leg lacks has min = max = 0
    Real max[kJoints];          ///< rad
    Real comfort_min[kJoints];  ///< rad
    Real comfort_max[kJoints];  ///< rad
    Real per_below[kJoints];    ///< 1 / (min - comfort_min), 1/rad; 0 where these are the same
    Real per_above[kJoints];    ///< 1 / (max - comfort_max), 1/rad; 0 where these are the same
    Real stiffness[kJoints];    ///< 1
    Real rest[kJoints];         ///< rad
};

using Leg = Chain<double>;

/// `bones` in m, of which at least one is longer than 0.
Leg make_leg(const std::array<double, kBones>& bones, const std::array<JointRange, kJoints>& joints) noexcept;

LegPose rest_pose(const Leg& leg) noexcept;

/// Each angle moved to the nearest that its joint allows.
LegPose within_limits(const Leg& leg, const LegPose& pose) noexcept;

/// By how much the joint that is furthest past its limit is past it, rad; 0 when none is.
double violation(const Leg& leg, const LegPose& pose) noexcept;

/// m, in the leg's frame: where each bone begins, and the foot.
std::array<Vec3, kBones + 1> joint_positions(const Leg& leg, const LegPose& pose) noexcept;

/// m, in the leg's frame. Poses within [-pi, pi].
Vec3 foot_position(const Leg& leg, const LegPose& pose) noexcept;

/// Unit vectors.
struct Frame {
    Vec3 x, y, z;
};

/// Of the last bone, in the leg's frame: x along it, z across the plane.
Frame foot_frame(const Leg& leg, const LegPose& pose) noexcept;

/// Of one joint, in the leg's frame: how fast the foot moves (m/rad), and the axis it turns about (unit).
struct JointColumn {
    Vec3 move;
    Vec3 axis;
};
using Jacobian = std::array<JointColumn, kJoints>;

Jacobian jacobian(const Leg& leg, const LegPose& pose) noexcept;

}  // namespace orbweaver::spider
