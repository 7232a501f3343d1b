#include "box.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

std::size_t dark_in(const Bitmap& bitmap, const Box& box) {
    std::size_t count = 0;
    for (std::uint32_t y = box.top; y < box.bottom; ++y)
        for (std::uint32_t x = box.left; x < box.right; ++x) count += bitmap.row(y)[x];
    return count;
}

}  // namespace

TEST_CASE("the box of what is dark holds all of it, and no smaller one does", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Bitmap bitmap = test::random_bitmap(17, 23, seed % 2 == 0 ? 0.02 : 0.2, seed);
        const RandomStream random(seed, "box");
        const auto left = static_cast<std::uint32_t>(random.bits(0) % 17),
                   top = static_cast<std::uint32_t>(random.bits(1) % 23);
        const Box within{left, top, left + static_cast<std::uint32_t>(random.bits(2) % (18 - left)),
                         top + static_cast<std::uint32_t>(random.bits(3) % (24 - top))};
        const Box box = dark_box(bitmap.values, 17, within);
        const std::size_t all = dark_in(bitmap, within);
        CHECK(box.empty() == (all == 0));
        if (all == 0) continue;
        CHECK((box.left >= within.left && box.top >= within.top));
        CHECK((box.right <= within.right && box.bottom <= within.bottom));
        CHECK(dark_in(bitmap, box) == all);
        CHECK(dark_in(bitmap, {box.left + 1, box.top, box.right, box.bottom}) < all);
        CHECK(dark_in(bitmap, {box.left, box.top + 1, box.right, box.bottom}) < all);
        CHECK(dark_in(bitmap, {box.left, box.top, box.right - 1, box.bottom}) < all);
        CHECK(dark_in(bitmap, {box.left, box.top, box.right, box.bottom - 1}) < all);
    }
}

TEST_CASE("a box that is turned around is empty, and has widths below nothing", "[unit]") {
    CHECK(Box{3, 0, 3, 5}.empty());
    CHECK(Box{0, 5, 3, 5}.empty());
    CHECK_FALSE(Box{0, 0, 1, 1}.empty());
    CHECK(Box{5, 9, 2, 1}.width() == -3);
    CHECK(Box{5, 9, 2, 1}.height() == -8);
}
