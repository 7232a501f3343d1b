#pragma once

#include <vector>

#include "network.hpp"
#include "spring_system.hpp"

namespace orbweaver::peers {

/// What every peer integrates: a settled taut web of some 2000 particles on which a wind is put suddenly, and
/// stays. Nothing depends on time, so that no method that looks back over many steps has to begin again.
struct Problem {
    mass_spring::Network network;
    std::vector<Vec3> x, v;  ///< m, m/s, at t = 0
    Vec3 gravity{0, -9.81, 0};
    double drag = 1e-8;      ///< N s/m
    std::vector<Vec3> wind;  ///< N per particle
    double duration = 1;     ///< s

    mass_spring::Surroundings surroundings() const { return {gravity, drag, wind}; }
};

/// The thesis's web, found in form with the shipped silks and settled in still air to 1e-12 N; the wind is a
/// tenth of the thesis's generator, 0.1 uN on every particle: a breeze, in which the web stays taut. Throws
/// Fault(diverged) where it does not settle. `spring_damping` in N s/m.
Problem web_in_wind(double spring_damping);

/// The largest distance of a particle from where it should be, m; infinite where that is not a number or there
/// are no particles.
double largest_error(const std::vector<Vec3>& x, const std::vector<Vec3>& exact);

}  // namespace orbweaver::peers
