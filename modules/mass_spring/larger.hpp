#pragma once

#include <cmath>

namespace orbweaver::mass_spring {

/// The larger of `so_far` and |value|; a NaN in either stays.
inline double larger(double so_far, double value) noexcept {
    return std::abs(value) <= so_far || std::isnan(so_far) ? so_far : std::abs(value);
}

}  // namespace orbweaver::mass_spring
