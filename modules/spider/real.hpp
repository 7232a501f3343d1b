#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#include "orbweaver/targets.hpp"

namespace orbweaver::spider {

/// Four doubles at once, and eight: a register with AVX, and with AVX-512.
using Lanes4 = double __attribute__((vector_size(32)));
using Lanes8 = double __attribute__((vector_size(64)));

/// What a comparison of Reals gives: one bool, or one for each lane (all bits set or none).
template <class Real>
using Mask = decltype(Real{} < Real{});

// Algorithms are written once for a Real, which is one double or lanes of them: the same operations in the
// same order, and so the same bits.

template <class Real>
inline constexpr std::size_t kLanesOf = sizeof(Real) / sizeof(double);

template <class Real>
ORBWEAVER_INLINE Real load(const double* from) noexcept {
    Real lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

template <class Real>
ORBWEAVER_INLINE void store(double* to, const Real& lanes) noexcept {
    std::memcpy(to, &lanes, sizeof lanes);
}

using std::sqrt;
ORBWEAVER_INLINE Lanes4 sqrt(const Lanes4& s) noexcept {
    return Lanes4{sqrt(s[0]), sqrt(s[1]), sqrt(s[2]), sqrt(s[3])};
}
ORBWEAVER_INLINE Lanes8 sqrt(const Lanes8& s) noexcept {
    return Lanes8{sqrt(s[0]), sqrt(s[1]), sqrt(s[2]), sqrt(s[3]),
                  sqrt(s[4]), sqrt(s[5]), sqrt(s[6]), sqrt(s[7])};
}

template <class Real>
ORBWEAVER_INLINE Real select(const Mask<Real>& mask, const Real& yes, const Real& no) noexcept {
    return mask ? yes : no;
}

template <class Real>
ORBWEAVER_INLINE bool any(const Mask<Real>& mask) noexcept {
    if constexpr (kLanesOf<Real> == 1) {
        return mask;
    } else if constexpr (kLanesOf<Real> == 8) {
        Mask<Lanes4> low, high;
        std::memcpy(&low, &mask, sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&mask) + sizeof low, sizeof high);
        return any<Lanes4>(low | high);
    } else {
        return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
    }
}

template <class Real>
ORBWEAVER_INLINE Real smaller(const Real& a, const Real& b) noexcept {
    return select(a < b, a, b);
}

template <class Real>
ORBWEAVER_INLINE Real larger(const Real& a, const Real& b) noexcept {
    return select(a > b, a, b);
}

ORBWEAVER_INLINE double magnitude(double a) noexcept { return std::fabs(a); }
template <class Lanes>
ORBWEAVER_INLINE Lanes magnitude(const Lanes& a) noexcept {
    const auto bits = (Mask<Lanes>)a & 0x7FFFFFFFFFFFFFFF;  // all but the sign's
    return (Lanes)bits;
}

template <class Real>
ORBWEAVER_INLINE Real clamp(const Real& value, const Real& low, const Real& high) noexcept {
    return smaller(larger(value, low), high);
}

}  // namespace orbweaver::spider
