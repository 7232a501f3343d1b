#pragma once

#include "method.hpp"

namespace orbweaver::mass_spring {

/// The largest h (s) for which `method` does not amplify q'' + mu q' + omega^2 q = 0, mu the damping rate in
/// 1/s and omega the angular frequency in rad/s. 0 when there is none, infinite when every step will do. The
/// system that the mode is of may have a larger spectral radius (1/s), which stabilised methods go by.
double stability_limit(const MethodInfo& method, double angular_frequency, double damping_rate,
                       double spectral_radius = 0);

}  // namespace orbweaver::mass_spring
