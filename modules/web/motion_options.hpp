#pragma once

#include "mass_spring/linear_solver.hpp"
#include "mass_spring/network.hpp"
#include "mass_spring/simulation_settings.hpp"
#include "orbweaver/diagnostic.hpp"
#include "orbweaver/options.hpp"

namespace orbweaver::web {

/// How a [web] table asks for its motion to be integrated.
struct Motion {
    mass_spring::SimulationSettings settings;  ///< no method: it is to be chosen, by tolerance or budget
    double tolerance = 0;                      ///< m over the run, for the choice; 0: by budget
    double budget = 0;                         ///< s a frame, for the choice
    mass_spring::LinearSolverKind linear_solver = mass_spring::LinearSolverKind::automatic;
};

/// A tolerance that the method cannot keep, and an automatic choice without a goal, are reported where the
/// scene says them.
Motion read_motion(const Options& options, Diagnostics& faults);

/// So are damped springs that the method does not take, whether an option damps them or a file of a network.
void check_damping(const Options& options, const Motion& motion, const mass_spring::Network& network,
                   Diagnostics& faults);

}  // namespace orbweaver::web
