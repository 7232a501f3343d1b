#pragma once

#include <vector>

#include "creature.hpp"
#include "orbweaver/contracts/sketch.hpp"

namespace orbweaver::spider {

/// What a creature believes: yellow, the polygon underfoot; cyan, what it feels ahead and behind, and the up
/// that it turns to; white, the hull's order of the feet that stand, and where its middle is above them; green,
/// feet that stand; orange, swings under way, their ends, and the ray that ends there; red, feet without a
/// hold; bones from green, where a joint is in comfort, to red at its limit.
void add_sketch(const Surface& surface, const Conduct& conduct, const CreatureState& state,
                std::vector<SketchLine>& lines);

}  // namespace orbweaver::spider
