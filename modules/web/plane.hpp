#pragma once

#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver::web {

/// A point of a plane, m.
struct PlanePoint {
    double x = 0;  ///< along Plane::across
    double y = 0;  ///< along Plane::up
};

/// Twice the signed area of the triangle a, b, c: positive when they turn counter-clockwise.
constexpr double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) noexcept {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// An orthonormal frame in which a web lies: across x up = normal.
struct Plane {
    Vec3 origin;
    Vec3 across{1, 0, 0};
    Vec3 up{0, 1, 0};
    Vec3 normal{0, 0, 1};

    PlanePoint project(const Vec3& p) const noexcept { return {dot(p - origin, across), dot(p - origin, up)}; }
    Vec3 lift(const PlanePoint& p) const noexcept { return origin + across * p.x + up * p.y; }
};

/// A plane with how far the points it was fitted to spread along it, m (root mean square).
struct PlaneFit {
    Plane plane;
    double length = 0;  ///< along the direction of largest spread
    double width = 0;   ///< across that, within the plane; 0 for points on one line
};

/// The plane of least squared distance to the points, through their centroid. Its `up` is as near to y as
/// the plane allows and its normal looks towards +z (towards +x, +y where z does not decide).
PlaneFit fit_plane(std::span<const Vec3> points);

/// The frame through `origin` with this unit normal, made upright as above.
Plane upright_plane(const Vec3& origin, Vec3 normal) noexcept;

}  // namespace orbweaver::web
