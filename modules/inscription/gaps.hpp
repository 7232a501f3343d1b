#pragma once

#include "raster.hpp"

namespace orbweaver::inscription {

/// Random gaps (figure 6.18 of the thesis): dark discs with radii of 0.7 % to 2 % of the shorter side, strewn
/// until at least `density` (0 to 0.5) of all pixels is dark. The n-th disc depends on the seed and n alone:
/// more density adds discs and moves none.
Bitmap random_gaps(std::uint32_t width, std::uint32_t height, double density, std::uint64_t seed);

}  // namespace orbweaver::inscription
