#include "open_way.hpp"

#include "footholds.hpp"
#include "ground.hpp"
#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {

bool is_open(const Surface& surface, const Footing& ground, const Vec3& way, double length,
             const Vec3& gravity) noexcept {
    const SurfaceStep step = stride_along(surface, ground, way, length).step;
    if (step.answer != Answer::found) return true;
    return step.stop != StepStop::border && holds(surface.grip(step.end.at.face), step.end.up, gravity);
}

Vec3 open_way(const Surface& surface, const Footing& ground, const Vec3& wanted, double time,
              const Vec3& gravity) noexcept {
    const double speed = norm(wanted);
    if (speed == 0 || is_open(surface, ground, wanted / speed, speed * time, gravity)) return wanted;
    const Vec3 left = cross(ground.up, wanted);
    // The side on which the creature already is: nearer to where it goes.
    const double side = dot(left, ground.forward) >= 0 ? 1 : -1;
    for (int degrees = 30; degrees <= 180; degrees += 30)
        for (const double sign : {side, -side}) {
            const Vec3 way = cos_degrees(degrees) * wanted + (sign * sin_degrees(degrees)) * left;
            if (is_open(surface, ground, way / speed, speed * time, gravity)) return way;
        }
    return wanted;
}

}  // namespace orbweaver::spider
