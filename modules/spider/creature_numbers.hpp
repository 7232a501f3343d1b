#pragma once

#include <cstddef>
#include <type_traits>

#include "creature.hpp"

namespace orbweaver::spider {

/// Calls `each` with every number of a creature of so many legs, by reference, always in the same order: what a
/// saved state holds of it.
template <class Each>
void each_number(CreatureState& state, std::size_t legs, Each&& each) {
    const auto vector = [&](Vec3& v) {
        each(v.x);
        each(v.y);
        each(v.z);
    };
    Footing& footing = state.ground.footing;
    each(footing.at.face);
    for (double& weight : footing.at.weights) each(weight);
    each(footing.side);
    for (Vec3* v : {&footing.forward, &footing.position, &footing.up, &state.ground.velocity,
                    &state.ground.facing, &state.forward, &state.shift, &state.sway, &state.turn.up,
                    &state.turn.from, &state.turn.to, &state.wander.point})
        vector(*v);
    each(state.depth);
    each(state.bend);
    each(state.turn.step);
    each(state.turn.steps);
    each(state.wander.wait);
    each(state.wander.draws);
    each(state.wall.side);
    each(state.wall.climbs);
    each(state.wall.left);
    each(state.wall.draws);
    each(state.pause.stands);
    each(state.pause.left);
    each(state.pause.stood);
    each(state.pause.draws);
    each(state.phase);
    each(state.jitter_draws);
    each(state.spin);
    each(state.strain);
    for (std::size_t leg = 0; leg < legs; ++leg) {
        Foot& foot = state.feet[leg];
        each(state.start[leg]);
        each(state.progress[leg]);
        each(state.jitter[leg]);
        for (Vec3* v : {&foot.place, &foot.home, &foot.swing.start, &foot.swing.end, &foot.swing.start_up,
                        &foot.swing.end_up})
            vector(*v);
        each(foot.swing.height);
        each(foot.path);
        each(foot.holds);
        each(foot.rim);
        each(foot.searches);
        for (double& angle : state.poses[leg]) each(angle);
    }
}

inline std::size_t count_numbers(std::size_t legs) {
    CreatureState state;
    std::size_t count = 0;
    each_number(state, legs, [&](auto&) { ++count; });
    return count;
}

/// Whole numbers below 2^53, which all of these are, are kept as they are.
inline void write_numbers(CreatureState& state, std::size_t legs, double* to) {
    each_number(state, legs, [&](auto& number) { *to++ = static_cast<double>(number); });
}

inline void read_numbers(const double* from, std::size_t legs, CreatureState& state) {
    each_number(state, legs, [&](auto& number) {
        number = static_cast<std::remove_reference_t<decltype(number)>>(*from++);
    });
}

}  // namespace orbweaver::spider
