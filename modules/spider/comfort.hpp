#pragma once

#include "leg.hpp"
#include "real.hpp"

namespace orbweaver::spider {

/// How willingly joint j turns the way of `wish`'s sign, from 1 to 0: the inverse of its resistance. Within
/// comfort, and back towards it, 1. On the way from comfort (x = 0) to the limit (x = 1) it is
/// (1 - x)(1 - stiffness x), so that resistance grows without bound and nothing moves past the limit.
template <class Real>
ORBWEAVER_INLINE Real compliance(const Chain<Real>& leg, std::size_t j, const Real& angle,
                                 const Real& wish) noexcept {
    const Mask<Real> up = wish > 0;
    const Real limit = select(up, leg.max[j], leg.min[j]);
    const Real comfort = select(up, leg.comfort_max[j], leg.comfort_min[j]);
    const Real per_width = select(up, leg.per_above[j], leg.per_below[j]);
    const Real zero{}, one = zero + 1;
    const Real x = clamp(Real((angle - comfort) * per_width), zero, one);
    return select(angle == limit, zero, Real((1 - x) * (1 - leg.stiffness[j] * x)));
}

/// What a spring that is slack within comfort, and a faint one towards rest, would like joint j to turn by,
/// rad.
template <class Real>
ORBWEAVER_INLINE Real comfort_wish(const Chain<Real>& leg, std::size_t j, const Real& angle, double comfort,
                                   double rest) noexcept {
    return comfort * (clamp(angle, leg.comfort_min[j], leg.comfort_max[j]) - angle) +
           rest * (leg.rest[j] - angle);
}

}  // namespace orbweaver::spider
