#pragma once

#include "body_pose.hpp"
#include "body_shape.hpp"
#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// m: how deep a body whose creature stands on `ground` reaches below the surface, at most; 0: it is clear. A
/// ball is below it as deep as its lowest point, and so is one whose middle the surface hides from the
/// thorax's.
double penetration(const Surface& surface, const BodyShape& shape, const Footing& ground,
                   const BodyPose& pose) noexcept;

/// Moves a body, by no more than `most` m in all, off walls and edges that its up has not turned for yet:
/// its deepest ball straight away from the surface, time and again until all are clear. `shift` (m) is by how
/// much it is off its place already, and becomes what it takes; returns the penetration that is left.
double keep_off(const Surface& surface, const BodyShape& shape, const Footing& ground,
                const BodyPose& unshifted, double most, Vec3& shift) noexcept;

}  // namespace orbweaver::spider
