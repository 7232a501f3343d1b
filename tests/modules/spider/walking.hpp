#pragma once

#include <cmath>
#include <string>

#include "creature.hpp"
#include "creatures.hpp"
#include "land.hpp"

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

/// What one of them came to that wandered from `place` on for so many minutes, as chance number `seed` had it.
inline CreatureMeasures wandered(const land::Land& land, const Conduct& conduct, std::uint64_t seed,
                                 const Vec3& place, int minutes) {
    const RandomStream random(seed, "wanderer");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand(place, {0, 1, 0}, {1, 0, 0.3}), state);
    for (int i = 0; i < minutes * 3600; ++i)
        advance_creature(land.surface(), conduct, {random, {}}, kFrame, state, measures);
    return measures;
}

/// What has to hold of it wherever it walked; `most_torn`: of its steps, that its legs no longer reached.
inline void check_walk(const CreatureMeasures& measures, const Conduct& conduct, double most_torn = 0.05) {
    const double frames = static_cast<double>(measures.frames);
    CHECK(measures.lost_frames == 0);
    CHECK(measures.worst_slip == 0);
    CHECK(measures.worst_reach <= 1e-6);  // of leg length
    CHECK(measures.worst_joint <= 0);
    CHECK(measures.worst_penetration == 0);
    CHECK(measures.worst_turn <= conduct.turn_rate * kFrame * (1 + 1e-5));  // told to 0.001 degrees
    CHECK(measures.distance > frames * kFrame * 0.025);  // a sixth of its top speed, pauses counted
    CHECK(static_cast<double>(measures.feet_down) / frames > 5);
    CHECK(static_cast<double>(measures.forced_steps) < most_torn * static_cast<double>(measures.steps));
}

}  // namespace orbweaver::spider::test
