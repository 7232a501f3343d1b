#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// The largest step at which a method is linearly stable on a system at one configuration.
struct Advice {
    double stable_step = 0;  ///< s; infinite when nothing can oscillate, 0 when no step is stable
    std::size_t spring = 0;  ///< the spring that takes most part in the mode that sets it
    bool has_spring = false;
    double angular_frequency = 0;  ///< rad/s of that mode, undamped
    double damping_rate = 0;       ///< 1/s, mu in q'' + mu q' + omega^2 q = 0 of that mode
    std::string sentence;          ///< all of this in words, with units
};

/// Finds the stiffest and the most damped mode of M^-1 K and M^-1 C by Lanczos iteration on the tangent at
/// x, and asks the method itself, by stepping q'' + mu q' + omega^2 q = 0, for the largest step whose
/// one-step matrix has a spectral radius of at most 1.
Advice advise(const SpringSystem& system, std::span<const Vec3> x, const MethodInfo& method);

}  // namespace orbweaver::mass_spring
