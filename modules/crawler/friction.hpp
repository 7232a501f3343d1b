#pragma once

#include <cstdint>

#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// How a body slides. `one_way` is Miller's (1988): what slides backwards is stopped, all else is free.
enum class FrictionLaw : std::uint8_t { coulomb, one_way };

struct Friction {
    FrictionLaw law = FrictionLaw::coulomb;
    double forward = 0.3, backward = 0.3, sideways = 0.3;  ///< coefficients, 1
    double adhesion = 0;  ///< m/s^2, that a point bears to be torn from the ground with
};

/// A velocity along a surface after friction. `v` (m/s) lies in the surface's plane, as do `spine`, unit, along
/// the body, and `side`, unit, across. `pressing`: m/s, the velocity into the surface that the surface took.
///
/// Coulomb's friction on scales (Hu and Shelley 2012) bears mu(u) times the pressing along each axis, u =
/// v/|v|: mu_i u_i, with the coefficient of the way that it slides. It is taken at the end of the impulse, so
/// that nothing is turned round, and what the impulse can stop rests.
Vec3 slide(const Friction& friction, double pressing, const Vec3& v, const Vec3& spine,
           const Vec3& side) noexcept;

}  // namespace orbweaver::crawler
