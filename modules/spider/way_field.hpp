#pragma once

#include <cstdint>
#include <vector>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// The shortest ways along a surface to one point of it, from everywhere: a wave that starts at the point
/// passes from triangle to triangle as a circle about where it would have started in the triangle's plane (fast
/// marching after Kimmel and Sethian 1998, with circular fronts as Novotni and Klein 2002). Exact as long as
/// the wave has passed flat or unfolded land only; a way round a vertex is the vertex's distance more. Made
/// once; O(n log n).
class WayField {
public:
    WayField() = default;
    /// `surface` outlives it.
    WayField(const Surface& surface, const SurfacePoint& target);

    /// Where the target seems to be, from a place on the surface: as far away (m) as the way is long, straight
    /// on where the way begins. The target itself where there is no way, as between shells.
    Vec3 seen_from(const SurfacePoint& at) const noexcept;
    /// Whether a way leads to the target from there.
    bool leads_from(const SurfacePoint& at) const noexcept;
    std::size_t memory_bytes() const noexcept { return distance_.capacity() * sizeof(double); }

private:
    const Surface* surface_ = nullptr;
    std::uint32_t face_ = kNoFace;  // of the target
    Vec3 target_;                   // m
    std::vector<double> distance_;  // m, of each vertex; infinite where no way leads
};

/// The points of the shortest way between two, at most `step` m from each other; both ends are among them, and
/// only they where none leads.
std::vector<Vec3> shortest_way(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                               double step);

}  // namespace orbweaver::spider
