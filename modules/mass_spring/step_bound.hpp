#pragma once

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// A step (s) at which `method` is linearly stable however the particles of a system may stand, as long as no
/// spring is shorter than half its rest length; 0 where the method has none, infinite where nothing can
/// oscillate, where no oscillation limits the method, or where curves (see MaterialLaw) may become ever
/// steeper. By bound_spectrum().
double bound_step(const SpringSystem& system, const MethodInfo& method);

}  // namespace orbweaver::mass_spring
