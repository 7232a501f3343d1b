#pragma once

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// A step (s) at which `method` is linearly stable however the particles of a system may stand, as long as no
/// spring is shorter than half its rest length; 0 where the method has none, infinite where nothing can
/// oscillate.
///
/// No arrangement is stiffer than all springs along one line with neighbors swinging against each other:
/// the eigenvalues of M^-1 K are at most the spectral radius of the matrix with sum_j k_ij/m_i on its diagonal
/// and k_ij/sqrt(m_i m_j) beside it, and the same holds for damping. That matrix is not negative, so for any
/// positive q its radius is at most max_i (A q)_i/q_i (Collatz and Wielandt), which power iteration tightens.
double bound_step(const SpringSystem& system, const MethodInfo& method);

}  // namespace orbweaver::mass_spring
