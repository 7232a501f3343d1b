#include "gaps.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace orbweaver::inscription;

namespace {

double share(const Bitmap& bitmap) {
    return std::accumulate(bitmap.values.begin(), bitmap.values.end(), 0.0) /
           static_cast<double>(bitmap.values.size());
}

}  // namespace

TEST_CASE("gaps darken the share that is asked for, and at most one disc more", "[unit]") {
    for (const double density : {0.0, 0.01, 0.1, 0.5}) {
        const double found = share(random_gaps(400, 300, density, 7));
        CHECK(found >= density);
        CHECK(found < density + 3.2 * 6 * 6 / (400 * 300.0));  // pi r^2 of the largest, r = 0.02 x 300
    }
}

TEST_CASE("a seed gives the same gaps again, another seed others, and more density adds some", "[unit]") {
    const Bitmap few = random_gaps(200, 200, 0.05, 1), many = random_gaps(200, 200, 0.2, 1);
    CHECK(random_gaps(200, 200, 0.05, 1) == few);
    CHECK_FALSE(random_gaps(200, 200, 0.05, 2) == few);
    for (std::size_t i = 0; i < few.values.size(); ++i) CHECK(few.values[i] <= many.values[i]);
}

TEST_CASE("gaps are small: no square larger than a disc is dark where they are few", "[unit]") {
    const Bitmap gaps = random_gaps(600, 600, 0.002, 3);
    std::uint32_t longest = 0;
    for (std::uint32_t y = 0; y < 600; ++y) {
        std::uint32_t run = 0;
        for (std::uint32_t x = 0; x < 600; ++x) {
            run = gaps.row(y)[x] != 0 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    CHECK(longest >= 8);  // a disc's diameter is 8.4 to 24 pixels
    CHECK(longest <= 25);
}
