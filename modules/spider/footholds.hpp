#pragma once

#include <cstdint>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// A place for a foot.
struct Foothold {
    bool found = false;
    SurfacePoint at;
    Vec3 position;     ///< m, on the surface
    Vec3 up;           ///< unit, on the side that the creature stands on
    bool rim = false;  ///< the surface ends there, before the place that was wanted
};

/// How a foothold is looked for.
enum class FootholdWay : std::uint8_t {
    rays,     ///< along up and down from where it is wanted, the nearer hit (ap Cenydd and Teahan 2005, 4.1)
    surface,  ///< by a ray along the surface, from the creature to it (5.1, its future work)
};

/// On `surface` where the way leads from a creature on `ground` whose up is `up`, to `wanted` (m); rays are
/// `reach` m long.
Foothold look_for_foothold(const Surface& surface, FootholdWay way, const Footing& ground, const Vec3& up,
                           const Vec3& wanted, double reach) noexcept;

/// The places that a foot tries, one after the other, in turn: the wanted one, then those on three rings about
/// it, the outermost `search` m from it.
inline constexpr int kFootholdTries = 25;
Vec3 foothold_try(int number, const Footing& ground, const Vec3& wanted, double search) noexcept;

/// The first of them that `serves`, a predicate of a Foothold; none: the leg has nothing to stand on.
template <class Serves>
Foothold find_foothold(const Surface& surface, FootholdWay way, const Footing& ground, const Vec3& up,
                       const Vec3& wanted, double reach, double search, const Serves& serves) noexcept {
    for (int i = 0; i < kFootholdTries; ++i) {
        const Vec3 place = foothold_try(i, ground, wanted, search);
        const Foothold foothold = look_for_foothold(surface, way, ground, up, place, reach);
        if (foothold.found && serves(foothold)) return foothold;
    }
    return {};
}

/// Whether a foot stays on that face: where it is climbable, or so nearly level that its friction holds.
bool holds(const SurfaceGrip& grip, const Vec3& up, const Vec3& gravity) noexcept;

}  // namespace orbweaver::spider
