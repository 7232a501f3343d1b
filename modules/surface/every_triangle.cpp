#include "every_triangle.hpp"

#include "closest_point.hpp"
#include "face_record.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

SurfaceHit first_hit_of_all(const TriangleSet& set, const SurfaceRay& ray) noexcept {
    NearestCrossing nearest(ray.reach);
    const WatertightRay<> tight(ray);
    for (std::uint32_t face = 0; face < set.triangles.size(); ++face)
        nearest.try_face(tight, rows_of(set, face), face);
    return nearest.hit();
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
    if (nearest.face == kNoFace) return {};
    return {Answer::found, nearest, least};
}

}  // namespace orbweaver::surface
