#include "footholds.hpp"

#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {
namespace {

Vec3 across(const Vec3& v, const Vec3& unit) noexcept { return v - dot(v, unit) * unit; }

Foothold from_hit(const SurfaceHit& hit, const Vec3& up) noexcept {
    if (hit.answer != Answer::found) return {};
    return {true, hit.at, hit.position, dot(hit.normal, up) < 0 ? -1 * hit.normal : hit.normal};
}

Foothold by_rays(const Surface& surface, const Vec3& up, const Vec3& wanted, double reach) noexcept {
    const SurfaceHit below = surface.first_hit({wanted, -1 * up, reach});
    const SurfaceHit above = surface.first_hit({wanted, up, reach});
    const bool from_below =
        below.answer == Answer::found && (above.answer != Answer::found || below.distance <= above.distance);
    return from_hit(from_below ? below : above, up);
}

Foothold along_surface(const Surface& surface, const Footing& ground, const Vec3& wanted) noexcept {
    const Vec3 way = across(wanted - ground.position, ground.up);
    const double length = norm(way);
    if (length == 0) return {true, ground.at, ground.position, ground.up};
    const SurfaceStep placed = surface.place(ground.at, ground.up, way / length);
    if (placed.answer != Answer::found) return {};
    const SurfaceStep step = surface.stride(placed.end, length, {}).step;
    if (step.answer != Answer::found || step.stop != StepStop::none) return {};
    return {true, step.end.at, step.end.position, step.end.up};
}

bool serves(const Surface& surface, const Foothold& foothold, const LegReach& leg) noexcept {
    if (!foothold.found) return false;
    const double stretch = distance(foothold.position, leg.hip);
    return stretch >= leg.least && stretch <= leg.most &&
           holds(surface.grip(foothold.at.face), foothold.up, leg.gravity);
}

}  // namespace

bool holds(const SurfaceGrip& grip, const Vec3& up, const Vec3& gravity) noexcept {
    if (grip.climbable || gravity == Vec3{}) return true;
    // The tangent of the slope is at most the coefficient of friction.
    const double level = -dot(up, gravity) / norm(gravity);
    return level > 0 && 1 - level * level <= grip.friction * grip.friction * level * level;
}

Foothold find_foothold(const Surface& surface, FootholdWay way, const Footing& ground, const Vec3& up,
                       const Vec3& wanted, const LegReach& leg, double search) noexcept {
    const auto look = [&](const Vec3& place) {
        return way == FootholdWay::rays ? by_rays(surface, up, place, leg.most)
                                        : along_surface(surface, ground, place);
    };
    const Foothold first = look(wanted);
    if (serves(surface, first, leg)) return first;
    constexpr int kRings = 3, kSides = 8;
    const Vec3 ahead = ground.forward, left = cross(ground.up, ahead);
    for (int ring = 1; ring <= kRings; ++ring)
        for (int side = 0; side < kSides; ++side) {
            const double degrees = 360.0 * side / kSides, out = search * ring / kRings;
            const Vec3 about = out * (cos_degrees(degrees) * ahead + sin_degrees(degrees) * left);
            const Foothold next = look(wanted + about);
            if (serves(surface, next, leg)) return next;
        }
    return {};
}

}  // namespace orbweaver::spider
