#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orbweaver::inscription {

/// A picture of one value a pixel, rows from the top, no padding.
template <class T>
struct Raster {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<T> values;

    Raster() = default;
    Raster(std::uint32_t w, std::uint32_t h)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    T* row(std::uint32_t y) noexcept { return values.data() + static_cast<std::size_t>(y) * width; }
    const T* row(std::uint32_t y) const noexcept { return values.data() + static_cast<std::size_t>(y) * width; }

    friend bool operator==(const Raster&, const Raster&) = default;
};

/// Bi-level: 1 is dark, to be inscribed; 0 is bright.
using Bitmap = Raster<std::uint8_t>;
/// As a file has them: 0 is black, 255 is white.
using ByteShades = Raster<std::uint8_t>;
/// 0 is black, 1 is white.
using Shades = Raster<float>;

}  // namespace orbweaver::inscription
