#pragma once

#include <vector>

#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// A part of a thread, as shares of its length.
struct Part {
    double from = 0;
    double to = 1;
};

/// Of a mesh: shorter parts of a thread would be stiffer than any method could step over.
inline constexpr double kShortestPart = 0.5;

/// The parts of a thread from a to b that lie on dark pixels, none shorter than `shortest` (pixels): darkness
/// and brightness of less than that are overlooked, so that no part left between them is shorter either.
/// Nothing for a thread of less than two such lengths that is not dark throughout the larger part of it.
std::vector<Part> dark_parts(const Bitmap& bitmap, const Spot& a, const Spot& b, double shortest);

}  // namespace orbweaver::inscription
