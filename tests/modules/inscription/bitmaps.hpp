#pragma once

#include "orbweaver/random.hpp"
#include "raster.hpp"

namespace orbweaver::test {

/// Each pixel dark with the same chance.
inline inscription::Bitmap random_bitmap(std::uint32_t width, std::uint32_t height, double density,
                                         std::uint64_t seed) {
    inscription::Bitmap bitmap(width, height);
    const RandomStream random(seed, "bitmap");
    for (std::size_t i = 0; i < bitmap.values.size(); ++i)
        bitmap.values[i] = random.uniform(i) < density ? 1 : 0;
    return bitmap;
}

}  // namespace orbweaver::test
