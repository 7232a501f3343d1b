#include "every_triangle.hpp"

#include "closest_point.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

SurfaceHit first_hit_of_all(const TriangleSet& set, const SurfaceRay& ray) noexcept {
    NearestCrossing nearest(ray.reach);
    const WatertightRay tight(ray);
    for (std::uint32_t face = 0; face < set.triangles.size(); ++face)
        nearest.try_face(tight, set.vertices, set.triangles[face], face);
    return nearest.hit(set);
}

SurfaceHit closest_point_of_all(const TriangleSet& set, const Vec3& point, double reach) noexcept {
    SurfacePoint nearest;
    double least = reach;
    for (std::uint32_t face = 0; face < set.triangles.size(); ++face) {
        const SurfacePoint at{face, closest_weights(set.corners(face), point)};
        const double away = distance(position_of(set, at), point);
        if (!(away < least || (away == least && nearest.face == kNoFace))) continue;
        nearest = at;
        least = away;
    }
    SurfaceHit hit;
    if (nearest.face != kNoFace) fill_in(hit, set, nearest, least);
    return hit;
}

}  // namespace orbweaver::surface
