#pragma once

#include <initializer_list>
#include <numeric>
#include <string_view>

#include "box.hpp"
#include "orbweaver/random.hpp"
#include "raster.hpp"
#include "target.hpp"

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

/// As it is drawn by rows of equal length: '#' is dark.
inline inscription::Bitmap drawn(std::initializer_list<std::string_view> rows) {
    inscription::Bitmap bitmap(static_cast<std::uint32_t>(rows.begin()->size()),
                               static_cast<std::uint32_t>(rows.size()));
    std::uint32_t y = 0;
    for (const std::string_view row : rows) {
        for (std::uint32_t x = 0; x < bitmap.width; ++x) bitmap.row(y)[x] = row[x] == '#' ? 1 : 0;
        ++y;
    }
    return bitmap;
}

inline void fill(inscription::Bitmap& bitmap, const inscription::Box& box, std::uint8_t value = 1) {
    for (std::uint32_t y = box.top; y < box.bottom; ++y)
        for (std::uint32_t x = box.left; x < box.right; ++x) bitmap.row(y)[x] = value;
}

inline std::size_t count_dark(const inscription::Bitmap& bitmap) {
    return std::accumulate(bitmap.values.begin(), bitmap.values.end(), std::size_t{0});
}

/// A view of `coverage`, which it does not outlive.
inline inscription::Target target_of(const inscription::Bitmap& coverage) {
    return {coverage.width, coverage.height, coverage.values, coverage.values};
}

}  // namespace orbweaver::test
