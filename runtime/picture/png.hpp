#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace orbweaver::picture {

/// What a PNG is made for: many pictures in little time, or one that many people will fetch.
enum class PngEffort : std::uint8_t { fast, small };

/// A PNG file in memory, of sRGB pixels (3 bytes each, rows from the top, no padding) and marked as such.
/// Throws Fault(limit) when there is no memory for it, Fault(internal) for sizes that contradict each other.
std::vector<std::uint8_t> encode_png(int width, int height, std::span<const std::uint8_t> rgb,
                                     PngEffort effort = PngEffort::fast);

}  // namespace orbweaver::picture
