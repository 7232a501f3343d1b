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

inline constexpr SurfaceHit kRefusedHit{Answer::refused, {}, 0, {}, {}};

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

/// Fills in a hit of which the place and the distance are known. In place, and corners by reference: copying
/// them costs as much as all else.
inline void fill_in(SurfaceHit& hit, const TriangleSet& set, const SurfacePoint& at, double distance) noexcept {
    const Corners& c = set.triangles[at.face];
    const Vec3& p = set.vertices[c[0]];
    const Vec3 a = set.vertices[c[1]] - p;
    const Vec3 b = set.vertices[c[2]] - p;
    const double u = at.weights[1], v = at.weights[2];
    hit.answer = Answer::found;
    hit.at.face = at.face;
    hit.at.weights[0] = at.weights[0];
    hit.at.weights[1] = u;
    hit.at.weights[2] = v;
    hit.distance = distance;
    hit.position = {p.x + u * a.x + v * b.x, p.y + u * a.y + v * b.y, p.z + u * a.z + v * b.z};
    const double nx = a.y * b.z - a.z * b.y, ny = a.z * b.x - a.x * b.z, nz = a.x * b.y - a.y * b.x;
    const double square = nx * nx + ny * ny + nz * nz;
    if (square > 1e-280 && square < 1e280) {
        const double length = std::sqrt(square);
        hit.normal = {nx / length, ny / length, nz / length};
    } else {
        hit.normal = extreme_normal(set.corners(at.face));
    }
}

}  // namespace orbweaver::surface
