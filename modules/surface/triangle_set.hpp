#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver::surface {

using Corners = std::array<std::uint32_t, 3>;

/// Triangles over shared vertices, as the queries read them; indices are sound (checked when they were baked).
struct TriangleSet {
    std::span<const Vec3> vertices;  ///< m
    std::span<const Corners> triangles;

    std::array<Vec3, 3> corners(std::uint32_t face) const noexcept {
        const Corners& c = triangles[face];
        return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
    }
};

inline constexpr SurfaceHit kRefusedHit{Answer::refused, {}, 0};
inline constexpr SurfaceHit kFailedHit{Answer::failed, {}, 0};

/// Twice the face's area along its normal (m^2).
inline Vec3 area_normal(const std::array<Vec3, 3>& p) noexcept { return cross(p[1] - p[0], p[2] - p[0]); }

inline Vec3 unit(const Vec3& v) noexcept { return v / norm(v); }

inline Vec3 position_of(const TriangleSet& set, const SurfacePoint& at) noexcept {
    const auto p = set.corners(at.face);
    return p[0] + at.weights[1] * (p[1] - p[0]) + at.weights[2] * (p[2] - p[0]);
}

/// The unit vector along (p[1] - p[0]) x (p[2] - p[0]) = n when its square leaves the range of numbers.
Vec3 extreme_normal(const std::array<Vec3, 3>& p) noexcept;

/// Unit normal of a triangle that has an area.
inline Vec3 unit_normal(const std::array<Vec3, 3>& p) noexcept {
    const Vec3 n = area_normal(p);
    const double square = dot(n, n);
    return square > 1e-280 && square < 1e280 ? n / std::sqrt(square) : extreme_normal(p);
}

inline Vec3 face_normal(const TriangleSet& set, std::uint32_t face) noexcept {
    return unit_normal(set.corners(face));
}

}  // namespace orbweaver::surface
