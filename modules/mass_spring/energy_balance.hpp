#pragma once

#include <span>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// Where the energy of a stretch of motion came from. Springs, gravity and drag give none, so what external
/// forces did not bring in is the method's doing: its error, or, where it is as large as the motion itself,
/// an instability.
struct EnergyBalance {
    double gain = 0;      ///< J, from nowhere; negative: dissipated
    double turnover = 0;  ///< J, kinetic energy at both ends and the work done
    double rounding = 0;  ///< J, of the sums

    /// Whether the motion can be a solution at all.
    bool holds() const noexcept { return gain <= 0.5 * turnover + rounding; }
};

/// From x0, where the energy was `before`, to state 1, during which the system's external forces were constant.
/// Where it has hooks, they know what they and the external forces did.
EnergyBalance balance_energy(const SpringSystem& system, const Energy& before, std::span<const Vec3> x0,
                             std::span<const Vec3> x1, std::span<const Vec3> v1) noexcept;

/// W, that drag and the springs' damping take. Dashpots of arms are not counted.
double dissipated_power(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v) noexcept;

}  // namespace orbweaver::mass_spring
