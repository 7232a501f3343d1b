#pragma once

#include <cmath>
#include <cstddef>

#include "orbweaver/lanes.hpp"

namespace orbweaver::mass_spring {

using orbweaver::load, orbweaver::store;

ORBWEAVER_INLINE Lanes sqrt(const Lanes& s) noexcept {
    return Lanes{std::sqrt(s[0]), std::sqrt(s[1]), std::sqrt(s[2]), std::sqrt(s[3])};
}

ORBWEAVER_INLINE double sum(const Lanes& of) noexcept { return (of[0] + of[1]) + (of[2] + of[3]); }

/// A vector in each lane.
struct Vec3Lanes {
    Lanes x, y, z;
};

/// From three planes (see Packing).
ORBWEAVER_INLINE Vec3Lanes load(const double* from, std::size_t plane) noexcept {
    return {load(from), load(from + plane), load(from + 2 * plane)};
}

ORBWEAVER_INLINE void store(double* to, std::size_t plane, const Vec3Lanes& v) noexcept {
    store(to, v.x);
    store(to + plane, v.y);
    store(to + 2 * plane, v.z);
}

ORBWEAVER_INLINE Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
ORBWEAVER_INLINE Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
ORBWEAVER_INLINE Vec3Lanes operator*(const Vec3Lanes& a, const Lanes& s) noexcept {
    return {a.x * s, a.y * s, a.z * s};
}
ORBWEAVER_INLINE Lanes dot(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace orbweaver::mass_spring
