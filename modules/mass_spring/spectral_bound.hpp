#pragma once

#include <algorithm>

#include "network.hpp"

namespace orbweaver::mass_spring {

struct SpectralBound {
    double angular_frequency = 0;  ///< rad/s, of M^-1 K
    double damping_rate = 0;       ///< 1/s, of M^-1 C

    /// 1/s: at least |lambda| of x'' = a(x, x') as a system of order one.
    double radius() const noexcept { return std::max(angular_frequency, damping_rate); }
};

/// What no mode of a network exceeds, however its particles may stand, as long as no spring is shorter than
/// half its rest length, or, with a curve, longer than twice that. `drag` (N s/m) is the same for all
/// particles.
///
/// No arrangement is stiffer than all springs along one line with neighbors swinging against each other:
/// the eigenvalues of M^-1 K are at most the spectral radius of the matrix with sum_j k_ij/m_i on its diagonal
/// and k_ij/sqrt(m_i m_j) beside it, and the same holds for damping. That matrix is not negative, so for any
/// positive q its radius is at most max_i (A q)_i/q_i (Collatz and Wielandt), which power iteration tightens.
SpectralBound bound_spectrum(const Network& network, double drag);

}  // namespace orbweaver::mass_spring
