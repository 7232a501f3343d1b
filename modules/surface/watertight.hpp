#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "face_record.hpp"
#include "floats.hpp"
#include "orbweaver/lanes.hpp"

namespace orbweaver::surface {

/// Whether a ray asks for anything: finite, with a direction, and a reach that is a number >= 0.
inline bool is_sound(const SurfaceRay& ray) noexcept {
    return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3{} && ray.reach >= 0;
}

/// The power of two by which a direction is multiplied so that its longest component becomes 1 or more and less
/// than 2; less for one whose numbers are near the end of their range.
ORBWEAVER_INLINE double power_to_one(const Vec3& v) noexcept {
    const double longest =
        std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), std::numeric_limits<double>::min()});
    constexpr std::uint64_t kExponent = 0x7FF0000000000000, kOfTwoInAll = 0x7FE0000000000000;
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(longest) & kExponent;
    return std::bit_cast<double>(kOfTwoInAll - std::min(exponent, kOfTwoInAll - (std::uint64_t{1} << 52)));
}

/// 1 / power, of such a power.
ORBWEAVER_INLINE double inverse_of_power(double power) noexcept {
    constexpr std::uint64_t kOfTwoInAll = 0x7FE0000000000000;
    return std::bit_cast<double>(kOfTwoInAll - std::bit_cast<std::uint64_t>(power));
}

/// Four units in the last place: how far a corner may be from where it was meant to be, of its largest number.
inline constexpr double kGrain = 4 * std::numeric_limits<double>::epsilon();

/// What a line says of a triangle, corner by corner: the function of the edge opposite to it, which is the
/// corner's weight times `total` where the line passes inside, and its depth.
struct EdgeFunctions {
    Lanes edges;  ///< the last is 0
    Lanes depths;

    ORBWEAVER_INLINE double total() const noexcept { return edges[0] + edges[1] + edges[2]; }
    ORBWEAVER_INLINE double least() const noexcept { return std::min(std::min(edges[0], edges[1]), edges[2]); }
    /// Whether all are below 0, or above; true of a 0 as its sign has it.
    template <class Wide>
    ORBWEAVER_INLINE bool have_sign(bool negative) const noexcept {
        return Wide::signs(edges) == (negative ? 7U : 0U);
    }
};

/// The axis along which a direction is longest.
ORBWEAVER_INLINE std::size_t axis_of(const Vec3& direction) noexcept {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    if (x > y) return z > x ? 2 : 0;
    return z > y ? 2 : 1;
}

ORBWEAVER_INLINE std::array<double, 3> weights_of(const Lanes& edges, double scale) noexcept {
    return {edges[0] * scale, edges[1] * scale, edges[2] * scale};
}

/// What a crossing's edge functions are multiplied by to be its weights, and how far it is, in lengths of the
/// direction.
struct Crossing {
    double scale;
    double distance;
};

enum class Meets : std::uint8_t { not_at_all, grazes, crosses };

/// The ray-triangle test of Woop, Benthin and Wald (2013), in double: the ray is sheared on to the axis along
/// which it is longest, where three edge functions say on which side of each edge it passes. What an edge's
/// function says depends on its two ends alone and changes sign with their order, so that of the faces
/// around an edge or a vertex at least one is hit. A ray that passes outside of an edge by no more than the
/// rounding of the numbers it is made of is said to graze the triangle: so that one which is aimed at the rim
/// of what it sees is not lost to the last bit of its direction.
///
/// Nothing is divided before it is known whether the triangle is met: with d the direction and z its axis, a
/// corner is sheared to (d_z x - d_x z, d_z y - d_y z), d_z times what the paper has.
template <class Wide = FourWide>
class WatertightRay {
public:
    /// For a direction whose length is near 1; `axis` is axis_of(direction).
    ORBWEAVER_INLINE WatertightRay(const Vec3& origin, const Vec3& direction, std::size_t axis) noexcept
        : x_(axis == 2 ? 0 : axis + 1), y_(axis == 0 ? 2 : axis - 1), z_(axis) {
        const double *o = &origin.x, *d = &direction.x;
        Wide::fill(origin_x_, o[x_]);
        Wide::fill(origin_y_, o[y_]);
        Wide::fill(origin_z_, o[z_]);
        Wide::fill(along_, d[z_]);
        Wide::fill(shear_x_, d[x_]);
        Wide::fill(shear_y_, d[y_]);
    }
    /// For a direction of any length but 0.
    ORBWEAVER_INLINE explicit WatertightRay(const SurfaceRay& ray) noexcept
        : WatertightRay(ray, power_to_one(ray.direction), axis_of(ray.direction)) {}

    template <class Rows>
    ORBWEAVER_INLINE EdgeFunctions edges(const Rows& rows) const noexcept {
        const Lanes z = rows.row(z_) - origin_z_;
        const Lanes x = (rows.row(x_) - origin_x_) * along_ - shear_x_ * z;
        const Lanes y = (rows.row(y_) - origin_y_) * along_ - shear_y_ * z;
        return {before(x) * after(y) - before(y) * after(x), z};
    }

    /// What meets() asks, of up to four triangles side by side, each in its place; to the same bits.
    struct Many {
        std::array<Lanes, 3> edges;
        Lanes scale, distance;
        unsigned near;    ///< bit i: triangle i is crossed, or passed so closely that it may be grazed
        unsigned beside;  ///< bit i: it is passed
    };
    /// `rows(axis, corner)` is that coordinate of all.
    template <class Rows>
    ORBWEAVER_INLINE Many meet_many(const Rows& rows) const noexcept {
        std::array<Lanes, 3> x, y, z;
        for (std::size_t i = 0; i < 3; ++i) {
            z[i] = rows(z_, i) - origin_z_;
            x[i] = (rows(x_, i) - origin_x_) * along_ - shear_x_ * z[i];
            y[i] = (rows(y_, i) - origin_y_) * along_ - shear_y_ * z[i];
        }
        Many many;
        auto& e = many.edges;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t before = (i + 2) % 3, after = (i + 1) % 3;
            e[i] = x[before] * y[after] - y[before] * x[after];
        }
        const Lanes total = e[0] + e[1] + e[2];
        const Lanes inverse = 1 / (total * along_);
        many.scale = inverse * along_;
        many.distance = (e[0] * z[0] + e[1] * z[1] + e[2] * z[2]) * inverse * unit_;
        const Lanes a = flipped_by(total, e[0]), b = flipped_by(total, e[1]), c = flipped_by(total, e[2]);
        const Lanes lesser = a < b ? a : b, least = lesser < c ? lesser : c;
        many.near = Wide::signs(reinterpret_cast<Lanes>(least >= absolute(total) * -kWorthALook));
        many.beside = Wide::signs(reinterpret_cast<Lanes>(least < 0));
        return many;
    }

    /// Whether the direction's longest component is 0 or above: `total()` is then below 0 for a triangle whose
    /// normal points along the line.
    ORBWEAVER_INLINE bool points_along() const noexcept { return !std::signbit(along_[0]); }

    ORBWEAVER_INLINE Crossing crossing(const EdgeFunctions& e) const noexcept {
        const Lanes each = e.edges * e.depths;
        const double inverse = 1 / (e.total() * along_[0]);
        return {inverse * along_[0], (each[0] + each[1] + each[2]) * inverse * unit_};
    }

    /// Whether the triangle is met, on either face, at a distance in [0, reach]. `e` is what edges() said; of a
    /// triangle that is grazed it becomes what it would be on the rim.
    template <class Rows>
    ORBWEAVER_INLINE Meets meets(const Rows& rows, double reach, EdgeFunctions& e,
                                 Crossing& met) const noexcept {
        const double total = e.total();
        const double sign = std::copysign(1.0, total);
        const double least = EdgeFunctions{e.edges * sign, e.depths}.least();
        if (least < -kWorthALook * std::abs(total)) return Meets::not_at_all;
        const bool grazes = least < 0;
        if (grazes && !pull_to_rim(rows, sign, e)) return Meets::not_at_all;
        if (e.total() == 0) return Meets::not_at_all;  // seen edge-on: its neighbours are met instead
        met = crossing(e);
        if (!(met.distance >= 0 && met.distance <= reach)) return Meets::not_at_all;
        return grazes ? Meets::grazes : Meets::crosses;
    }

private:
    static constexpr double kWorthALook =
        1e-6;  // of the triangle: rounding is far below, unless it is far away

    ORBWEAVER_INLINE WatertightRay(const SurfaceRay& ray, double power, std::size_t axis) noexcept
        : WatertightRay(ray.origin, power * ray.direction, axis) {
        unit_ = power;
    }

    /// Each corner's place taken by the one before it, or after it.
    ORBWEAVER_INLINE static Lanes before(const Lanes& of) noexcept {
        return __builtin_shufflevector(of, of, 2, 0, 1, 3);
    }
    ORBWEAVER_INLINE static Lanes after(const Lanes& of) noexcept {
        return __builtin_shufflevector(of, of, 1, 2, 0, 3);
    }

    /// Whether the ray passes within rounding of an edge that it is outside of: each corner is known to a few
    /// units in the last place of its own numbers and of its distance from the ray's origin. If so, moves it
    /// there.
    template <class Rows>
    [[gnu::noinline]] bool pull_to_rim(const Rows& rows, double sign, EdgeFunctions& e) const noexcept {
        double grain[3], sheared[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = rows.row(x_)[i] - origin_x_[0], y = rows.row(y_)[i] - origin_y_[0],
                         z = rows.row(z_)[i] - origin_z_[0];
            sheared[i] = std::abs(x * along_[0] - shear_x_[0] * z) + std::abs(y * along_[0] - shear_y_[0] * z);
            grain[i] = kGrain * std::abs(along_[0]) *
                       (std::abs(x) + std::abs(y) + std::abs(z) + std::abs(origin_x_[0]) +
                        std::abs(origin_y_[0]) + std::abs(origin_z_[0]));
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            if (sign * e.edges[i] < -(sheared[j] * grain[k] + sheared[k] * grain[j] + grain[j] * grain[k]))
                return false;
        }
        for (std::size_t i = 0; i < 3; ++i)
            if (sign * e.edges[i] < 0) e.edges[i] = 0;
        return true;
    }

    Lanes origin_x_, origin_y_, origin_z_;
    Lanes along_, shear_x_, shear_y_;
    std::size_t x_, y_, z_;
    double unit_ = 1;  // of distance: lengths of the direction in one of what `along` is of
};

/// The nearest crossing found so far; of equally near ones the face of the lowest number, whatever the order.
/// What is only grazed counts when nothing is crossed.
class NearestCrossing {
public:
    explicit NearestCrossing(double reach) noexcept : crossed_{.reach = reach}, grazed_{.reach = reach} {}

    template <class Wide, class Rows>
    ORBWEAVER_INLINE void try_face(const WatertightRay<Wide>& ray, const Rows& rows,
                                   std::uint32_t face) noexcept {
        EdgeFunctions e = ray.edges(rows);
        Crossing met{};
        const auto meets = ray.meets(rows, crossed_.reach, e, met);
        if (meets == Meets::not_at_all) return;
        take(meets == Meets::crosses ? crossed_ : grazed_, e.edges, met, face);
    }
    /// Of a triangle that the line crosses, wherever that is.
    ORBWEAVER_INLINE void try_crossing(const Lanes& edges, const Crossing& met, std::uint32_t face) noexcept {
        if (met.distance >= 0) take(crossed_, edges, met, face);
    }

    bool crosses() const noexcept { return crossed_.face != kNoFace; }
    /// Of the nearest crossing, or the reach that was given.
    double reach() const noexcept { return crossed_.reach; }

    SurfaceHit hit() const noexcept {
        const Nearest& nearest = crosses() ? crossed_ : grazed_;
        if (nearest.face == kNoFace) return {};
        return {Answer::found, {nearest.face, weights_of(nearest.edges, nearest.scale)}, nearest.reach};
    }

private:
    struct Nearest {
        Lanes edges{};
        double reach, scale = 0;
        std::uint32_t face = kNoFace;
    };
    ORBWEAVER_INLINE static void take(Nearest& nearest, const Lanes& edges, const Crossing& met,
                                      std::uint32_t face) noexcept {
        if (!(met.distance <= nearest.reach) || (met.distance == nearest.reach && face > nearest.face)) return;
        nearest = {edges, met.distance, met.scale, face};
    }

    Nearest crossed_, grazed_;
};

}  // namespace orbweaver::surface
