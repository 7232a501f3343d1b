#pragma once

#include <array>
#include <cstdint>

namespace orbweaver::picture {

/// The light of an sRGB shade (IEC 61966-2-1); both in [0, 1].
float linear_from_srgb(float shade) noexcept;
/// Its inverse; light is clamped to [0, 1] first.
float srgb_from_linear(float light) noexcept;
/// srgb_from_linear() rounded to a byte.
std::uint8_t byte_from_linear(float light) noexcept;
/// linear_from_srgb() of every byte.
std::array<float, 256> linear_from_byte() noexcept;

}  // namespace orbweaver::picture
