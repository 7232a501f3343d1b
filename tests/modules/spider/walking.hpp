#pragma once

#include "creature.hpp"
#include "creatures.hpp"

/// How the tests' creatures walk.
namespace orbweaver::spider::test {

inline constexpr double kFrame = 1.0 / 60;

/// Of a species that outlives it, as a scene without options has it.
inline Conduct walking(const Species& species) {
    Conduct conduct;
    conduct.species = &species;
    conduct.gait = find_gait("tetrapod");
    conduct.path = find_stride_path("cycloid");
    conduct.solver = find_leg_solver("half_jacobian");
    const double leg = mean_leg_length(species);
    conduct.pace = {3 * leg, 0.2 * leg, 0.55 * leg, 0.75, 0.62};
    conduct.wander = {1, 0.3, 10};
    return conduct;
}

inline const Species& huntsman() {
    static const Species species = creature("huntsman");
    return species;
}

}  // namespace orbweaver::spider::test
