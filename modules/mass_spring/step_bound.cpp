#include "step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stability_limit.hpp"

namespace orbweaver::mass_spring {

double bound_step(const SpringSystem& system, const MethodInfo& method) {
    if (is_curved(system.network())) return std::numeric_limits<double>::infinity();
    const SpectralBound& bound = system.spectral_bound();
    const auto limit = [&](double omega, double mu) {
        return stability_limit(method, omega, mu, bound.radius());
    };
    const double omega = bound.angular_frequency, mu = bound.damping_rate;
    const double swinging = limit(omega, 0);
    // Linear theory then says nothing of the springs.
    if (omega > 0 && std::isinf(swinging)) return swinging;
    return std::min({swinging, limit(0, mu), limit(omega, mu)});
}

}  // namespace orbweaver::mass_spring
