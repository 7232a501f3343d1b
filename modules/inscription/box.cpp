#include "box.hpp"

#include <algorithm>
#include <cstddef>

namespace orbweaver::inscription {

Box dark_box(std::span<const std::uint8_t> coverage, std::uint32_t columns, const Box& within) {
    Box box{within.right, within.bottom, 0, 0};
    for (std::uint32_t y = within.top; y < within.bottom; ++y)
        for (std::uint32_t x = within.left; x < within.right; ++x) {
            if (coverage[static_cast<std::size_t>(y) * columns + x] == 0) continue;
            box.left = std::min(box.left, x);
            box.right = std::max(box.right, x + 1);
            box.top = std::min(box.top, y);
            box.bottom = y + 1;
        }
    return box;
}

}  // namespace orbweaver::inscription
