#include "dilate.hpp"

#include <algorithm>

namespace orbweaver::inscription {

namespace {

/// Dark pixels within the window are counted; the count moves with it, one in and one out.
void dilate_row(const std::uint8_t* in, std::uint8_t* out, std::uint32_t width, std::uint32_t radius) {
    std::uint32_t count = 0;
    for (std::uint32_t x = 0; x < std::min(radius, width); ++x) count += in[x];
    for (std::uint32_t x = 0; x < width; ++x) {
        if (x + radius < width) count += in[x + radius];
        out[x] = count > 0 ? 1 : 0;
        if (x >= radius) count -= in[x - radius];
    }
}

}  // namespace

// A square is a row of columns: first along rows, then along all columns at once.
Bitmap dilate(const Bitmap& bitmap, std::uint32_t size) {
    const std::uint32_t radius = size / 2;
    Bitmap wide(bitmap.width, bitmap.height);
    for (std::uint32_t y = 0; y < bitmap.height; ++y)
        dilate_row(bitmap.row(y), wide.row(y), bitmap.width, radius);
    Bitmap dilated(bitmap.width, bitmap.height);
    std::vector<std::uint32_t> counts(bitmap.width);
    const auto move_counts = [&](std::uint32_t y, std::uint32_t by) {
        const std::uint8_t* row = wide.row(y);
        for (std::uint32_t x = 0; x < bitmap.width; ++x) counts[x] += by * row[x];
    };
    for (std::uint32_t y = 0; y < std::min(radius, bitmap.height); ++y) move_counts(y, 1);
    for (std::uint32_t y = 0; y < bitmap.height; ++y) {
        if (y + radius < bitmap.height) move_counts(y + radius, 1);
        for (std::uint32_t x = 0; x < bitmap.width; ++x) dilated.row(y)[x] = counts[x] > 0 ? 1 : 0;
        if (y >= radius) move_counts(y - radius, ~std::uint32_t{0});  // minus one, modulo 2^32
    }
    return dilated;
}

}  // namespace orbweaver::inscription
