#pragma once

#include <span>
#include <vector>

#include "lattice.hpp"
#include "orbweaver/contracts/sketch.hpp"

namespace orbweaver::crawler {

/// Appended to `lines`: the spines of bodies whose masses are at x (m), from ring to ring, and by which forces
/// the ground presses on them (N), as long as two segments where it bears the weight of ten masses.
void add_sketch(const Lattice& lattice, const Build& build, double gravity, std::span<const Vec3> x,
                std::span<const Vec3> reaction, std::vector<SketchLine>& lines);

}  // namespace orbweaver::crawler
