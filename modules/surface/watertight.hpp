#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "triangle_set.hpp"

namespace orbweaver::surface {

/// Whether a ray asks for anything: finite, with a direction, and a reach that is a number >= 0.
inline bool is_sound(const SurfaceRay& ray) noexcept {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3{} && ray.reach >= 0;
}

/// Four units in the last place: how far a corner may be from where it was meant to be, of its largest number.
inline constexpr double kGrain = 4 * std::numeric_limits<double>::epsilon();

/// Where a ray meets a triangle: the weights of its corners, times a common factor `total`.
struct Crossing {
    double distance = 0;
    double u = 0, v = 0, w = 0;
    double total = 0;
};

/// The ray-triangle test of Woop, Benthin and Wald (2013), in double: the ray is sheared on to the axis along
/// which it is longest, where three edge functions say on which side of each edge it passes. What an edge's
/// function says depends on its two ends alone and changes sign with their order, so that of the faces
/// around an edge or a vertex at least one is hit. A ray that passes outside of an edge by no more than the
/// rounding of the numbers it is made of is said to graze the triangle: so that one which is aimed at the rim
/// of what it sees is not lost to the last bit of its direction.
class WatertightRay {
public:
    explicit WatertightRay(const SurfaceRay& ray) noexcept : origin_{ray.origin.x, ray.origin.y, ray.origin.z} {
        const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        z_ = std::abs(d[0]) > std::abs(d[1]) ? 0 : 1;
        if (std::abs(d[2]) > std::abs(d[z_])) z_ = 2;
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        scale_z_ = 1 / d[z_];
        shear_x_ = d[x_] * scale_z_;
        shear_y_ = d[y_] * scale_z_;
    }

    enum class Meets : std::uint8_t { not_at_all, grazes, crosses };

    /// Whether the triangle is met, on either face, at a distance in [0, reach].
    Meets meets(std::span<const Vec3> vertices, const Corners& corners, double reach,
                Crossing& out) const noexcept {
        Edges e = edges(vertices, corners);
        double total = e.u + e.v + e.w;
        const double sign = total < 0 ? -1 : 1;
        const double least = std::min({sign * e.u, sign * e.v, sign * e.w});
        const bool grazes = least < 0;
        if (grazes) {
            constexpr double kWorthALook =
                1e-6;  // of the triangle: rounding is far below, unless it is far away
            if (least < -kWorthALook * sign * total || !touches(e, sign, vertices, corners))
                return Meets::not_at_all;
            for (double* each : {&e.u, &e.v, &e.w})
                if (sign * *each < 0) *each = 0;
            total = e.u + e.v + e.w;
        }
        if (total == 0) return Meets::not_at_all;  // seen edge-on: its neighbours are met instead
        const double distance = scale_z_ * (e.u * e.a_z + e.v * e.b_z + e.w * e.c_z) / total;
        if (!(distance >= 0 && distance <= reach)) return Meets::not_at_all;
        out = {distance, e.u, e.v, e.w, total};
        return grazes ? Meets::grazes : Meets::crosses;
    }

    /// The edge that the ray passes outside of by most, measured against the triangle's winding as the ray sees
    /// it: 0, 1, 2 (from corner e to corner e+1), or -1 when it passes inside all three.
    int outside_of(std::span<const Vec3> vertices, const Corners& corners) const noexcept {
        const Edges e = edges(vertices, corners);
        const double sign = e.u + e.v + e.w < 0 ? -1 : 1;
        const double side[3] = {sign * e.w, sign * e.u, sign * e.v};  // of edges 01, 12, 20
        int least = 0;
        if (side[1] < side[least]) least = 1;
        if (side[2] < side[least]) least = 2;
        return side[least] < 0 ? least : -1;
    }

private:
    struct Edges {
        double u, v, w;        // of the edges opposite to corners 0, 1, 2
        double a_z, b_z, c_z;  // depth of the corners
    };

    /// Whether the ray passes within rounding of an edge that it is outside of: each corner is known to a few
    /// units in the last place of its own numbers and of its distance from the ray's origin.
    [[gnu::noinline]] bool touches(const Edges& e, double sign, std::span<const Vec3> vertices,
                                   const Corners& corners) const noexcept {
        const double function[3] = {e.u, e.v, e.w};
        double grain[3], sheared[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const auto* p = reinterpret_cast<const double*>(&vertices[corners[i]]);
            const double x = p[x_] - origin_[x_], y = p[y_] - origin_[y_], z = p[z_] - origin_[z_];
            sheared[i] = std::abs(x - shear_x_ * z) + std::abs(y - shear_y_ * z);
            grain[i] = kGrain * (std::abs(x) + std::abs(y) + std::abs(z) + std::abs(origin_[0]) +
                                 std::abs(origin_[1]) + std::abs(origin_[2]));
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            if (sign * function[i] < -(sheared[j] * grain[k] + sheared[k] * grain[j] + grain[j] * grain[k]))
                return false;
        }
        return true;
    }

    Edges edges(std::span<const Vec3> vertices, const Corners& corners) const noexcept {
        const auto* flat = reinterpret_cast<const double*>(vertices.data());
        const double* a = flat + 3 * std::size_t{corners[0]};
        const double* b = flat + 3 * std::size_t{corners[1]};
        const double* c = flat + 3 * std::size_t{corners[2]};
        const double a_z = a[z_] - origin_[z_], b_z = b[z_] - origin_[z_], c_z = c[z_] - origin_[z_];
        const double a_x = a[x_] - origin_[x_] - shear_x_ * a_z, a_y = a[y_] - origin_[y_] - shear_y_ * a_z;
        const double b_x = b[x_] - origin_[x_] - shear_x_ * b_z, b_y = b[y_] - origin_[y_] - shear_y_ * b_z;
        const double c_x = c[x_] - origin_[x_] - shear_x_ * c_z, c_y = c[y_] - origin_[y_] - shear_y_ * c_z;
        return {c_x * b_y - c_y * b_x, a_x * c_y - a_y * c_x, b_x * a_y - b_y * a_x, a_z, b_z, c_z};
    }

    double origin_[3];
    int x_ = 0, y_ = 0, z_ = 0;
    double shear_x_ = 0, shear_y_ = 0, scale_z_ = 0;
};

inline void fill_in(SurfaceHit& hit, const TriangleSet& set, std::uint32_t face,
                    const Crossing& crossing) noexcept {
    const double t = 1 / crossing.total;
    fill_in(hit, set, {face, {crossing.u * t, crossing.v * t, crossing.w * t}}, crossing.distance);
}

/// The nearest crossing found so far; of equally near ones the face of the lowest number, whatever the order.
/// What is only grazed counts when nothing is crossed.
class NearestCrossing {
public:
    explicit NearestCrossing(double reach) noexcept
        : crossed_{reach, kNoFace, {}}, grazed_{reach, kNoFace, {}} {}

    void try_face(const WatertightRay& ray, std::span<const Vec3> vertices, const Corners& corners,
                  std::uint32_t face) noexcept {
        Crossing crossing;
        const auto meets = ray.meets(vertices, corners, crossed_.reach, crossing);
        if (meets == WatertightRay::Meets::not_at_all) return;
        Nearest& nearest = meets == WatertightRay::Meets::crosses ? crossed_ : grazed_;
        if (crossing.distance > nearest.reach || (crossing.distance == nearest.reach && face > nearest.face))
            return;
        nearest = {crossing.distance, face, crossing};
    }

    bool crosses() const noexcept { return crossed_.face != kNoFace; }
    /// Of the nearest crossing, or the reach that was given.
    double reach() const noexcept { return crossed_.reach; }

    SurfaceHit hit(const TriangleSet& set) const noexcept {
        const Nearest& nearest = crosses() ? crossed_ : grazed_;
        SurfaceHit hit;
        if (nearest.face != kNoFace) fill_in(hit, set, nearest.face, nearest.crossing);
        return hit;
    }

private:
    struct Nearest {
        double reach;
        std::uint32_t face;
        Crossing crossing;
    };
    Nearest crossed_, grazed_;
};

}  // namespace orbweaver::surface
