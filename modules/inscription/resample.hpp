#pragma once

#include "raster.hpp"

namespace orbweaver::inscription {

/// A picture at another size: linear interpolation where it grows; where it shrinks, a triangle as wide as two
/// of the new pixels, so that nothing between samples is lost. The same size gives the same shades.
Shades resample(const ByteShades& picture, std::uint32_t width, std::uint32_t height);

}  // namespace orbweaver::inscription
