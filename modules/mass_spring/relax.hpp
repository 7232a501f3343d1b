#pragma once

#include <cstddef>
#include <span>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

struct Relaxation {
    double residual = 0;  ///< N, largest net force on a free particle
    std::size_t iterations = 0;
    bool converged = false;
};

/// Brings x to rest under its springs, gravity and external forces by dynamic relaxation with kinetic
/// damping (Barnes 1999): fictitious masses from local stiffness, velocities zeroed at each peak of
/// kinetic energy. Survives slack springs. Stops at `tolerance` newtons or after `max_iterations`.
Relaxation relax(SpringSystem& system, std::span<Vec3> x, double tolerance, std::size_t max_iterations);

}  // namespace orbweaver::mass_spring
