#pragma once

#include <cstdint>
#include <span>

namespace orbweaver::inscription {

/// A part of a raster: columns from left to before right, rows from top to before bottom.
struct Box {
    std::uint32_t left = 0, top = 0, right = 0, bottom = 0;

    double width() const noexcept { return static_cast<double>(right) - left; }
    double height() const noexcept { return static_cast<double>(bottom) - top; }
    bool empty() const noexcept { return right <= left || bottom <= top; }
};

/// The smallest box of all that is dark within another, of a raster of so many columns; empty where nothing is.
Box dark_box(std::span<const std::uint8_t> coverage, std::uint32_t columns, const Box& within);

}  // namespace orbweaver::inscription
