#pragma once

#include <span>
#include <vector>

#include "ground.hpp"
#include "lattice.hpp"
#include "orbweaver/contracts/sketch.hpp"

namespace orbweaver::crawler {

/// Appended to `lines`: the spines of bodies whose masses are at x (m), from ring to ring, and by which forces
/// the ground presses on them (N), as long as two segments where it bears the weight of ten masses.
void add_sketch(const Lattice& lattice, const Build& build, double gravity, std::span<const Vec3> x,
                std::span<const Vec3> reaction, std::vector<SketchLine>& lines);

/// Appended to `lines`: a cliff as far as `reach` (m) from its edge, across which it goes on from z = -reach to
/// z = reach: its profiles, and lines along it.
void add_cliff(const Cliff& cliff, double reach, std::vector<SketchLine>& lines);

}  // namespace orbweaver::crawler
