#include "step_bound.hpp"

#include <algorithm>

#include "adviser.hpp"
#include "spectral_bound.hpp"

namespace orbweaver::mass_spring {

double bound_step(const SpringSystem& system, const MethodInfo& method) {
    const auto [omega, mu] = bound_spectrum(system.network(), system.drag());
    return std::min({stability_limit(method, omega, 0), stability_limit(method, 0, mu),
                     stability_limit(method, omega, mu)});
}

}  // namespace orbweaver::mass_spring
