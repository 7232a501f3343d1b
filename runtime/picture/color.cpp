#include "picture/color.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace orbweaver::picture {

float linear_from_srgb(float shade) noexcept {
    return shade <= 0.04045F ? shade / 12.92F : std::pow((shade + 0.055F) / 1.055F, 2.4F);
}

float srgb_from_linear(float light) noexcept {
    const float l = std::clamp(light, 0.0F, 1.0F);
    return l <= 0.0031308F ? 12.92F * l : 1.055F * std::pow(l, 1 / 2.4F) - 0.055F;
}

std::uint8_t byte_from_linear(float light) noexcept {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(light)));
}

std::array<float, 256> linear_from_byte() noexcept {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear_from_srgb(static_cast<float>(i) / 255);
    return table;
}

}  // namespace orbweaver::picture
