#pragma once

#include "creature.hpp"

namespace orbweaver::spider {

/// How much a standing leg is strained: 1 where it steps out of turn. It is as far as it reaches, or its foot
/// as far from the middle of its stance as a stride takes it, and somewhat more.
double strain_of(const Limb& limb, const BodyPose& body, const Pace& pace, const Foot& foot) noexcept;

/// All feet down where stances begin; who finds no foothold searches.
void place_feet(const Surface& surface, const Conduct& conduct, CreatureState& state) noexcept;

/// One frame of dt s of a creature whose body has moved: who lifts finds a foothold, who swings goes on, who
/// searches goes on to another place, and every leg reaches for its foot. One that no longer reaches a foot
/// that stands lifts it from where it still is.
void step_feet(const Surface& surface, const Conduct& conduct, const RandomStream& random, double dt,
               CreatureState& state, CreatureMeasures& measures) noexcept;

}  // namespace orbweaver::spider
