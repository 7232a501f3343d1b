#pragma once

#include "leg_solver.hpp"
#include "posture.hpp"

namespace orbweaver::spider {

/// What is left of a target once it is known where it lies, in leg lengths; the same for one leg and for lanes.
template <class Real>
struct Aim {
    Triple<Real> at;    ///< no further than the leg is long
    Mask<Real> finite;  ///< where not, `at` is the root
    Mask<Real> beyond;  ///< it was further away
};

/// The rare cases of aim_at(). Numbers as large as doubles get do not overflow on the way.
template <class Real>
ORBWEAVER_INLINE Aim<Real> aim_far(const Chain<Real>& leg, const Triple<Real>& position) noexcept {
    const Real zero{}, one = zero + 1;
    Aim<Real> aim;
    aim.finite = 0 * position.x + 0 * position.y + 0 * position.z == zero;
    const Triple<Real> safe{select(aim.finite, position.x, zero), select(aim.finite, position.y, zero),
                            select(aim.finite, position.z, zero)};
    const Real largest =
        larger(larger(magnitude(safe.x), magnitude(safe.y)), larger(magnitude(safe.z), Real(zero + 1e-300)));
    const Triple<Real> scaled{safe.x / largest, safe.y / largest, safe.z / largest};
    const Real size = sqrt(dot(scaled, scaled));  // 1 to sqrt 3, or nothing
    aim.beyond = largest * leg.per_length * size > 1;
    const Real scale = select(aim.beyond, Real(1 / larger(size, one)), Real(largest * leg.per_length));
    aim.at = {scaled.x * scale, scaled.y * scale, scaled.z * scale};
    return aim;
}

/// `position` in m.
template <class Real>
ORBWEAVER_INLINE Aim<Real> aim_at(const Chain<Real>& leg, const Triple<Real>& position) noexcept {
    const Real zero{}, one = zero + 1;
    const Triple<Real> at{position.x * leg.per_length, position.y * leg.per_length,
                          position.z * leg.per_length};
    const Mask<Real> near = dot(at, at) <= 1;
    const Aim<Real> aim{at, one > zero, one < zero};
    if (!any<Real>(select(near, zero, one) > zero)) return aim;
    Aim<Real> far = aim_far(leg, position);
    far.at = {select(near, at.x, far.at.x), select(near, at.y, far.at.y), select(near, at.z, far.at.z)};
    return far;
}

/// Of a finite position in m.
Vec3 leg_lengths(const Leg& leg, const Vec3& position) noexcept;

/// On which side of the root the foot is in its plane: 1 along x, or -1.
double foot_side(const Leg& leg, const LegPose& pose) noexcept;

/// Turns yaw and tilt so that the plane of the bones goes through `target` (any unit), with it on the given
/// side of the root, as well as limits allow, if they are kept: yaw first, at the tilt that there is; then
/// tilt.
void face(const Leg& leg, const Vec3& target, double side, LegPose& pose, bool limited = true) noexcept;

/// The pose that the start of number `start` begins from, turned to face the target: rest, curled, hooked, over
/// the body, curled over, curled under, stretched, raised; then the same again.
LegPose start_pose(const Leg& leg, const Vec3& target, int start) noexcept;

}  // namespace orbweaver::spider
