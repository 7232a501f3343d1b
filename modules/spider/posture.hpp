#pragma once

#include "leg.hpp"
#include "rotor.hpp"

namespace orbweaver::spider {

/// A vector of Reals.
template <class Real>
struct Triple {
    Real x, y, z;
};

template <class Real>
ORBWEAVER_INLINE Real dot(const Triple<Real>& a, const Triple<Real>& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// What angles make of a chain. Lengths as a share of the leg's.
template <class Real>
struct Posture {
    Rotor<Real> yaw, tilt;
    Rotor<Real> along[kBones];  ///< the directions of bones in the plane
    Real x[kBones + 1];         ///< in the plane: where bones begin, and the foot
    Real y[kBones + 1];
};

template <class Real>
ORBWEAVER_INLINE Posture<Real> posture(const Chain<Real>& leg, const Real (&pose)[kJoints]) noexcept {
    Posture<Real> at;
    at.yaw = rotor(pose[kYaw]);
    at.tilt = rotor(pose[kTilt]);
    at.x[0] = at.y[0] = Real{};
    for (std::size_t i = 0; i < kBones; ++i) {
        const Rotor<Real> turn = rotor(pose[kPitch + i]);
        at.along[i] = i == 0 ? turn : at.along[i - 1] * turn;
        at.x[i + 1] = at.x[i] + leg.bone[i] * at.along[i].c;
        at.y[i + 1] = at.y[i] + leg.bone[i] * at.along[i].s;
    }
    return at;
}

/// From the plane's frame into the leg's: Ry(yaw) Rx(tilt) v.
template <class Real>
ORBWEAVER_INLINE Triple<Real> from_plane(const Posture<Real>& at, const Triple<Real>& v) noexcept {
    const Real y = at.tilt.c * v.y - at.tilt.s * v.z;
    const Real z = at.tilt.s * v.y + at.tilt.c * v.z;
    return {at.yaw.c * v.x + at.yaw.s * z, y, at.yaw.c * z - at.yaw.s * v.x};
}

/// From the leg's frame into the plane's.
template <class Real>
ORBWEAVER_INLINE Triple<Real> to_plane(const Posture<Real>& at, const Triple<Real>& v) noexcept {
    const Real x = at.yaw.c * v.x - at.yaw.s * v.z;
    const Real z = at.yaw.s * v.x + at.yaw.c * v.z;
    return {x, at.tilt.c * v.y + at.tilt.s * z, at.tilt.c * z - at.tilt.s * v.y};
}

/// The axis of joint j, in the plane's frame.
template <class Real>
ORBWEAVER_INLINE Triple<Real> joint_axis(const Posture<Real>& at, std::size_t j) noexcept {
    const Real zero{};
    if (j == kYaw) return {zero, at.tilt.c, -at.tilt.s};
    if (j == kTilt) return {zero + 1, zero, zero};
    return {zero, zero, zero + 1};
}

/// How fast the foot moves with joint j, in the plane's frame, leg lengths per rad: axis x (foot - joint).
template <class Real>
ORBWEAVER_INLINE Triple<Real> foot_velocity(const Posture<Real>& at, std::size_t j) noexcept {
    const Real zero{};
    const Real x = at.x[kBones], y = at.y[kBones];
    if (j == kYaw) return {at.tilt.s * y, -at.tilt.s * x, -at.tilt.c * x};
    if (j == kTilt) return {zero, zero, y};
    return {at.y[j - kPitch] - y, x - at.x[j - kPitch], zero};
}

}  // namespace orbweaver::spider
