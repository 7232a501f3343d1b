#include "dilate.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// The definition: dark where any pixel of the square about it is.
Bitmap dilate_by_definition(const Bitmap& bitmap, int size) {
    Bitmap dilated(bitmap.width, bitmap.height);
    const int width = static_cast<int>(bitmap.width), height = static_cast<int>(bitmap.height), r = size / 2;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int v = std::max(0, y - r); v <= std::min(height - 1, y + r); ++v)
                for (int u = std::max(0, x - r); u <= std::min(width - 1, x + r); ++u)
                    dilated.row(static_cast<std::uint32_t>(y))[x] |=
                        bitmap.row(static_cast<std::uint32_t>(v))[u];
    return dilated;
}

}  // namespace

TEST_CASE("dilation is what its definition says, also of pictures smaller than the square", "[unit]") {
    const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{61, 47}, {1, 1}, {1, 40},
                                                             {40, 1},  {3, 5}, {7, 7}};
    std::uint64_t seed = 0;
    for (const auto& [width, height] : sizes)
        for (const double density : {0.002, 0.03, 0.5})
            for (const std::uint32_t size : {1u, 3u, 7u, 15u}) {
                const Bitmap bitmap = test::random_bitmap(width, height, density, ++seed);
                CHECK(dilate(bitmap, size) == dilate_by_definition(bitmap, static_cast<int>(size)));
            }
}

TEST_CASE("one dark pixel becomes the square", "[unit]") {
    Bitmap bitmap(20, 20);
    bitmap.row(10)[9] = 1;
    const Bitmap dilated = dilate(bitmap, 7);
    for (std::uint32_t y = 0; y < 20; ++y)
        for (std::uint32_t x = 0; x < 20; ++x)
            CHECK(dilated.row(y)[x] == (x >= 6 && x <= 12 && y >= 7 && y <= 13 ? 1 : 0));
}
