#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace orbweaver::inscription {

/// The side of the square that coverage is dilated by, pixels (the thesis's).
inline constexpr std::uint32_t kDilation = 7;

/// What is to be inscribed into a web: a view of a baked target, or of arrays of one's own. Rows from the top;
/// 1 is dark, to be inscribed, 0 is bright.
struct Target {
    std::uint32_t width = 0;  ///< pixels
    std::uint32_t height = 0;
    std::span<const std::uint8_t> coverage;
    std::span<const std::uint8_t> dilated;  ///< coverage, dilated by kDilation

    std::size_t index(std::uint32_t x, std::uint32_t y) const noexcept {
        return static_cast<std::size_t>(y) * width + x;
    }
};

}  // namespace orbweaver::inscription
