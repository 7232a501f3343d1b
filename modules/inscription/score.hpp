#pragma once

#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

inline constexpr double kStrip = 5;  ///< pixels, the width of the neighborhood of a segment
inline constexpr int kLeastScore = 1, kBestScore = 10;

/// How well a segment of thread matches the target (figure 6.9 of the thesis): the intensities of all pixels
/// whose middles lie within a strip along the segment, kStrip wide, are summed in both pictures, and
///
///     score = floor(10 * ratio), held to 1..10.
///
/// Both pictures are bi-level and dilated; intensity is darkness. The ratio is the target's sum over the
/// source's. The thesis prints it the other way around, but a segment's own strip is all dark in the dilated
/// source, so that its ratio would never be below 1: as it is here it is the share of the segment's
/// neighborhood that the target covers, and ranges as the thesis says. 1 where the source is bright.
int match_score(const Bitmap& source, const Bitmap& target, const Spot& a, const Spot& b);

}  // namespace orbweaver::inscription
