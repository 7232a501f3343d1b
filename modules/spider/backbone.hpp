#pragma once

#include "creature.hpp"

namespace orbweaver::spider {

/// rad, up is positive: the bend between thorax and abdomen which lays the abdomen along the line from the feet
/// of the front half of the legs to those of the back half, of those that stand (ap Cenydd and Teahan 2005,
/// 4.1: the larger their average difference in elevation, the more bend), as far as the species lets it. 0
/// where a half has no foot down.
double wanted_bend(const Conduct& conduct, const CreatureState& state) noexcept;

/// One frame of dt s: bends the back towards that, no faster than `turn_rate`.
void bend_back(const Conduct& conduct, double dt, CreatureState& state) noexcept;

}  // namespace orbweaver::spider
