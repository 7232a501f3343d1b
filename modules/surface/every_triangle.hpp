#pragma once

#include "triangle_set.hpp"

namespace orbweaver::surface {

/// What a tree over the triangles would answer, by trying each of them in turn: the same bits. For surfaces of
/// a few triangles, and as a reference. Arguments are sound (see is_sound).
SurfaceHit first_hit_of_all(const TriangleSet& set, const SurfaceRay& ray) noexcept;
SurfaceHit closest_point_of_all(const TriangleSet& set, const Vec3& point, double reach) noexcept;

}  // namespace orbweaver::surface
