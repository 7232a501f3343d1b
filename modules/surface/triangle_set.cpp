#include "triangle_set.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::surface {

Vec3 face_normal(const TriangleSet& set, std::uint32_t face) noexcept {
    const auto p = set.corners(face);
    const Vec3 a = p[1] - p[0];
    const Vec3 b = p[2] - p[0];
    const Vec3 n = cross(a, b);
    const double square = dot(n, n);
    if (square > 1e-280 && square < 1e280) return n / std::sqrt(square);
    // The squares of tiny or huge edges leave the range of numbers: scaled first.
    const double largest =
        std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return unit(cross(a / largest, b / largest));
}

SurfaceHit found_at(const TriangleSet& set, const SurfacePoint& at, double distance) noexcept {
    return {Answer::found, at, distance, position_of(set, at), face_normal(set, at.face)};
}

}  // namespace orbweaver::surface
