#pragma once

#include <cstdint>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// A place for a foot.
struct Foothold {
    bool found = false;
    SurfacePoint at;
    Vec3 position;  ///< m, on the surface
    Vec3 up;        ///< unit, on the side that the creature stands on
};

/// What a leg can use.
struct LegReach {
    Vec3 hip;                    ///< m
    double least = 0, most = 0;  ///< m, from the hip to the foot
    Vec3 gravity;                ///< m/s^2; nothing: there is none to hold on against
};

/// How a foothold is looked for.
enum class FootholdWay : std::uint8_t {
    rays,     ///< along up and down from where it is wanted, the nearer hit (ap Cenydd and Teahan 2005, 4.1)
    surface,  ///< by a ray along the surface, from the creature to it (5.1, its future work)
};

/// On `surface` nearest to `wanted` (m) as the way goes, for a creature on `ground` whose up is `up`. Where
/// that is out of the leg's reach or gives no hold (see holds()), it searches about it on rings, at most
/// `search` m wide, and takes the first that serves. Not found: the leg has nothing to stand on.
Foothold find_foothold(const Surface& surface, FootholdWay way, const Footing& ground, const Vec3& up,
                       const Vec3& wanted, const LegReach& leg, double search) noexcept;

/// Whether a foot stays on that face: where it is climbable, or so nearly level that its friction holds.
bool holds(const SurfaceGrip& grip, const Vec3& up, const Vec3& gravity) noexcept;

}  // namespace orbweaver::spider
