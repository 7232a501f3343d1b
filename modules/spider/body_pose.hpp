#pragma once

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// Where a body is: its frame's origin is the thorax's middle.
struct BodyPose {
    Vec3 position;            ///< m
    Vec3 forward, up, right;  ///< unit
    double bend = 0;          ///< rad, of the abdomen, up is positive
};

/// From the body's frame, m.
inline Vec3 to_world(const BodyPose& pose, const Vec3& point) noexcept {
    return pose.position + point.x * pose.forward + point.y * pose.up + point.z * pose.right;
}

inline Vec3 from_world(const BodyPose& pose, const Vec3& point) noexcept {
    const Vec3 d = point - pose.position;
    return {dot(d, pose.forward), dot(d, pose.up), dot(d, pose.right)};
}

}  // namespace orbweaver::spider
