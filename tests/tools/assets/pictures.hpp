#pragma once

#include <functional>
#include <string>

#include "picture/png.hpp"

namespace orbweaver::test {

/// A PNG file of grays, of the shade that `shade` says of each pixel.
inline std::string gray_png(int width, int height, const std::function<std::uint8_t(int x, int y)>& shade) {
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) rgb.insert(rgb.end(), 3, shade(x, y));
    const auto png = picture::encode_png(width, height, rgb);
    return {png.begin(), png.end()};
}

}  // namespace orbweaver::test
