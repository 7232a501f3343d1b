#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "raster.hpp"

namespace orbweaver::inscription {

using Histogram = std::array<std::uint64_t, 256>;

/// Pixels by their shade, rounded to one of 256.
Histogram histogram(const Shades& shades);

/// The level that parts a histogram into two classes, level and below against above, with the greatest variance
/// between them (Otsu 1979); in the middle where several levels in a row do equally. Nothing where all pixels
/// have one shade.
std::optional<std::uint32_t> otsu_level(const Histogram& histogram);

/// The shade below which a pixel is dark, halfway above otsu_level(). Nothing where all pixels have one shade.
std::optional<double> otsu_threshold(const Shades& shades);

}  // namespace orbweaver::inscription
