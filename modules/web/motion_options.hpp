#pragma once

#include "mass_spring/simulation_settings.hpp"
#include "orbweaver/diagnostic.hpp"
#include "orbweaver/options.hpp"

namespace orbweaver::web {

/// How a [web] table asks for its motion to be integrated. A tolerance that its method cannot keep is reported
/// where the scene says it.
mass_spring::SimulationSettings read_motion(const Options& options, Diagnostics& faults);

}  // namespace orbweaver::web
