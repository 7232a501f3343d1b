#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "triangle_set.hpp"

namespace orbweaver::surface {

/// Whether a ray asks for anything: finite, with a direction, and a reach that is a number >= 0.
inline bool is_sound(const SurfaceRay& ray) noexcept {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3{} && ray.reach >= 0;
}

/// Where a ray meets a triangle: the weights of its corners, times a common factor `total`.
struct Crossing {
    double distance = 0;
    double u = 0, v = 0, w = 0;
    double total = 0;
};

/// The ray-triangle test of Woop, Benthin and Wald (2013), in double: the ray is sheared on to the axis along
/// which it is longest, where three edge functions say on which side of each edge it passes. What an edge's
/// function says depends on its two ends alone and changes sign with their order, so that of the faces
/// around an edge or a vertex at least one is hit.
class WatertightRay {
public:
    explicit WatertightRay(const SurfaceRay& ray) noexcept : origin_{ray.origin.x, ray.origin.y, ray.origin.z} {
        const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        z_ = std::abs(d[0]) > std::abs(d[1]) ? 0 : 1;
        if (std::abs(d[2]) > std::abs(d[z_])) z_ = 2;
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        shear_x_ = d[x_] / d[z_];
        shear_y_ = d[y_] / d[z_];
        scale_z_ = 1 / d[z_];
    }

    /// Whether the triangle is met, on either face, at a distance in [0, reach].
    bool meets(std::span<const Vec3> vertices, const Corners& corners, double reach,
               Crossing& out) const noexcept {
        const Edges e = edges(vertices, corners);
        if ((e.u < 0 || e.v < 0 || e.w < 0) && (e.u > 0 || e.v > 0 || e.w > 0)) return false;
        const double total = e.u + e.v + e.w;
        if (total == 0) return false;  // seen edge-on: its neighbours are met instead
        const double distance = scale_z_ * (e.u * e.a_z + e.v * e.b_z + e.w * e.c_z) / total;
        if (!(distance >= 0 && distance <= reach)) return false;
        out = {distance, e.u, e.v, e.w, total};
        return true;
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

/// The nearest crossing found so far; of equally near ones the face of the lowest number, whatever the order.
class NearestCrossing {
public:
    explicit NearestCrossing(double reach) noexcept : reach_(reach) {}

    void try_face(const WatertightRay& ray, std::span<const Vec3> vertices, const Corners& corners,
                  std::uint32_t face) noexcept {
        Crossing crossing;
        if (!ray.meets(vertices, corners, reach_, crossing)) return;
        if (face_ != kNoFace && crossing.distance == reach_ && face > face_) return;
        crossing_ = crossing;
        face_ = face;
        reach_ = crossing.distance;
    }

    double reach() const noexcept { return reach_; }
    std::uint32_t face() const noexcept { return face_; }

    SurfaceHit hit(const TriangleSet& set) const noexcept {
        if (face_ == kNoFace) return {};
        const double t = crossing_.total;
        return found_at(set, {face_, {crossing_.u / t, crossing_.v / t, crossing_.w / t}}, crossing_.distance);
    }

private:
    double reach_;
    std::uint32_t face_ = kNoFace;
    Crossing crossing_;
};

}  // namespace orbweaver::surface
