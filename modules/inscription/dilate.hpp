#pragma once

#include "raster.hpp"

namespace orbweaver::inscription {

/// Morphological dilation by a square of `size` x `size` pixels (odd) about each pixel: dark wherever something
/// dark lies within it. What lies beyond the edges is bright. The time of a pixel does not depend on `size`.
Bitmap dilate(const Bitmap& bitmap, std::uint32_t size);

}  // namespace orbweaver::inscription
