#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace orbweaver::picture {

/// sRGB, 3 bytes a pixel, rows from the top, no padding.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Shades of gray as sRGB codes them, a byte a pixel: 0 is black, 255 is white. Rows from the top, no padding.
struct GrayPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> shades;
};

/// Light on a linear scale, 3 floats a pixel, rows from the top; white paper is about 1.
struct LinearPicture {
    int width = 0;
    int height = 0;
    bool high_dynamic_range = false;  ///< values may exceed 1 by far
    std::vector<float> rgb;

    const float* pixel(int x, int y) const noexcept {
        return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x))];
    }
};

}  // namespace orbweaver::picture
