#pragma once

#include "orbweaver/targets.hpp"

namespace orbweaver::mass_spring {

/// x' = v, v' = -rate v goes on for some time: x += way v, v -= loss v.
template <class Number>
struct DragDrift {
    Number way;   ///< s, (1 - exp(-z))/rate with z = rate t
    Number loss;  ///< 1 - exp(-z)
};

/// For t seconds, which may be negative, by the first seven terms of the series of (1 - exp(-z))/z: exact to
/// order seven in t, and no bit rests on a library's exponential. Number: double, or several at once.
template <class Number>
ORBWEAVER_INLINE DragDrift<Number> drift_under_drag(const Number& rate, double t) noexcept {
    const Number z = rate * t;
    Number mean = 1 - z * (1.0 / 7);
    mean = 1 - z * (1.0 / 6) * mean;
    mean = 1 - z * (1.0 / 5) * mean;
    mean = 1 - z * (1.0 / 4) * mean;
    mean = 1 - z * (1.0 / 3) * mean;
    mean = 1 - z * (1.0 / 2) * mean;
    return {t * mean, z * mean};
}

}  // namespace orbweaver::mass_spring
