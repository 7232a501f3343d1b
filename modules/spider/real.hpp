#pragma once

#include <cmath>

#include "lanes.hpp"

namespace orbweaver::spider {

using mass_spring::Lanes;
using mass_spring::sqrt;
using std::sqrt;

/// What a comparison of Reals gives: one bool, or one for each lane (all bits set or none).
template <class Real>
using Mask = decltype(Real{} < Real{});

/// Algorithms are written once for a Real, which is one double or four lanes of them: the same operations in
/// the same order, and so the same bits.

ORBWEAVER_INLINE double select(bool mask, double yes, double no) noexcept { return mask ? yes : no; }
ORBWEAVER_INLINE Lanes select(const Mask<Lanes>& mask, const Lanes& yes, const Lanes& no) noexcept {
    return mask ? yes : no;
}

ORBWEAVER_INLINE bool any(bool mask) noexcept { return mask; }
ORBWEAVER_INLINE bool any(const Mask<Lanes>& mask) noexcept {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

template <class Real>
ORBWEAVER_INLINE Real smaller(const Real& a, const Real& b) noexcept {
    return select(a < b, a, b);
}

template <class Real>
ORBWEAVER_INLINE Real larger(const Real& a, const Real& b) noexcept {
    return select(a > b, a, b);
}

template <class Real>
ORBWEAVER_INLINE Real magnitude(const Real& a) noexcept {
    return larger(a, Real(-a));
}

template <class Real>
ORBWEAVER_INLINE Real clamp(const Real& value, const Real& low, const Real& high) noexcept {
    return smaller(larger(value, low), high);
}

}  // namespace orbweaver::spider
