#pragma once

#include <cstddef>
#include <span>

namespace orbweaver {

/// Blurs a raster of width x height values, rows one after the other, by a Gaussian of standard deviation
/// `sigma` pixels, above 0, cut at four of them; what lies beyond an edge is as the edge is. The same bits
/// everywhere.
void gaussian_blur(std::span<float> values, std::size_t width, std::size_t height, double sigma);

}  // namespace orbweaver
