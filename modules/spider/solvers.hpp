#pragma once

#include "leg_solver.hpp"

namespace orbweaver::spider {

/// Each in a file of its own; leg_solvers() lists them.
LegResult solve_half_jacobian(const Leg&, const LegTarget&, const LegSolverOptions&, LegPose&);
LegResult solve_full_jacobian(const Leg&, const LegTarget&, const LegSolverOptions&, LegPose&);
LegResult solve_fabrik(const Leg&, const LegTarget&, const LegSolverOptions&, LegPose&);
LegResult solve_fabrik_unlimited(const Leg&, const LegTarget&, const LegSolverOptions&, LegPose&);

}  // namespace orbweaver::spider
