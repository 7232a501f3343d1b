#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace orbweaver {

/// Three doubles in a row: positions in metres, velocities in m/s, forces in N; right-handed, y up.
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    constexpr Vec3& operator+=(const Vec3& o) noexcept {
        x += o.x;
        y += o.y;
        z += o.z;
        return *this;
    }
    constexpr Vec3& operator-=(const Vec3& o) noexcept {
        x -= o.x;
        y -= o.y;
        z -= o.z;
        return *this;
    }
    constexpr Vec3& operator*=(double s) noexcept {
        x *= s;
        y *= s;
        z *= s;
        return *this;
    }
    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};
static_assert(sizeof(Vec3) == 3 * sizeof(double));

constexpr Vec3 operator+(Vec3 a, const Vec3& b) noexcept { return a += b; }
constexpr Vec3 operator-(Vec3 a, const Vec3& b) noexcept { return a -= b; }
constexpr Vec3 operator-(const Vec3& a) noexcept { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) noexcept { return a *= s; }
constexpr Vec3 operator*(double s, Vec3 a) noexcept { return a *= s; }
constexpr Vec3 operator/(const Vec3& a, double s) noexcept { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) noexcept { return std::sqrt(dot(a, a)); }
inline double distance(const Vec3& a, const Vec3& b) noexcept { return norm(a - b); }
/// v without its part along `unit`, which has length 1.
constexpr Vec3 across(const Vec3& v, const Vec3& unit) noexcept { return v - dot(v, unit) * unit; }
inline bool is_finite(const Vec3& a) noexcept {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Between each of `a` and its fellow in `b`, the farthest. Not a number counts as infinitely far: comparisons
/// must not overlook it.
inline double largest_distance(std::span<const Vec3> a, std::span<const Vec3> b) noexcept {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double each = distance(a[i], b[i]);
        if (!(each <= largest)) largest = std::isfinite(each) ? each : std::numeric_limits<double>::infinity();
    }
    return largest;
}

/// The same memory as 3 n doubles, for algorithms that treat a state as one flat vector.
inline std::span<double> flat(std::span<Vec3> v) noexcept {
    return {reinterpret_cast<double*>(v.data()), 3 * v.size()};
}
inline std::span<const double> flat(std::span<const Vec3> v) noexcept {
    return {reinterpret_cast<const double*>(v.data()), 3 * v.size()};
}

}  // namespace orbweaver
