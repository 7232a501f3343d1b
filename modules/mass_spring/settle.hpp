#pragma once

#include <cstddef>
#include <span>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

struct Settlement {
    double residual = 0;          ///< N, largest net force on a free particle
    double tolerance = 0;         ///< N, as asked, or what rounding leaves of it
    std::size_t iterations = 0;   ///< of Newton's method
    std::size_t relaxations = 0;  ///< steps of dynamic relaxation, where Newton's method got stuck
    bool converged = false;
};

/// Brings x to rest under springs, gravity and external forces: Newton's method K u = f on the potential
/// energy, by the system's linear_solver(), with a line search that lets neither energy nor residual grow.
/// Where K is not positive definite (slack springs) the compressed springs' transverse part is clamped and a
/// multiple of the identity added, as large as progress asks (Levenberg and Marquardt); where that gets stuck,
/// dynamic relaxation goes on from there. x is left as it was where nothing brings it nearer to rest.
Settlement settle(SpringSystem& system, std::span<Vec3> x, double tolerance = 1e-12);

}  // namespace orbweaver::mass_spring
