#include "footholds.hpp"

#include "ground.hpp"

#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {
namespace {

Foothold from_hit(const Surface& surface, const SurfaceHit& hit, const Vec3& up) noexcept {
    if (hit.answer != Answer::found) return {};
    const Vec3 normal = surface.normal(hit.at.face);
    return {true, hit.at, surface.position(hit.at), dot(normal, up) < 0 ? -1 * normal : normal, false};
}

Foothold by_rays(const Surface& surface, const Vec3& up, const Vec3& wanted, double reach) noexcept {
    const SurfaceHit below = surface.first_hit({wanted, -1 * up, reach});
    const SurfaceHit above = surface.first_hit({wanted, up, reach});
    const bool from_below =
        below.answer == Answer::found && (above.answer != Answer::found || below.distance <= above.distance);
    return from_hit(surface, from_below ? below : above, up);
}

Foothold along_surface(const Surface& surface, const Footing& ground, const Vec3& wanted) noexcept {
    const Vec3 way = across(wanted - ground.position, ground.up);
    const double length = norm(way);
    if (length == 0) return {true, ground.at, ground.position, ground.up, false};
    const SurfaceStep step = stride_along(surface, ground, way / length, length).step;
    // Where the surface ends on the way, its rim is a place too.
    if (step.answer != Answer::found || step.stop == StepStop::limit) return {};
    return {true, step.end.at, step.end.position, step.end.up, step.stop == StepStop::border};
}

}  // namespace

bool holds(const SurfaceGrip& grip, const Vec3& up, const Vec3& gravity) noexcept {
    if (grip.climbable || gravity == Vec3{}) return true;
    // The tangent of the slope is at most the coefficient of friction.
    const double level = -dot(up, gravity) / norm(gravity);
    return level > 0 && 1 - level * level <= grip.friction * grip.friction * level * level;
}

Foothold look_for_foothold(const Surface& surface, FootholdWay way, const Footing& ground, const Vec3& up,
                           const Vec3& wanted, double reach) noexcept {
    return way == FootholdWay::rays ? by_rays(surface, up, wanted, reach)
                                    : along_surface(surface, ground, wanted);
}

Vec3 foothold_try(int number, const Footing& ground, const Vec3& wanted, double search) noexcept {
    constexpr int kRings = 3, kSides = (kFootholdTries - 1) / kRings;
    if (number == 0) return wanted;
    const int ring = (number - 1) / kSides + 1, side = (number - 1) % kSides;
    const double degrees = 360.0 * side / kSides, out = search * ring / kRings;
    const Vec3 left = cross(ground.up, ground.forward);
    return wanted + out * (cos_degrees(degrees) * ground.forward + sin_degrees(degrees) * left);
}

}  // namespace orbweaver::spider
