#include "score.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "dilate.hpp"
#include "plain_score.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

Bitmap filled(std::uint32_t width, std::uint32_t height) {
    Bitmap bitmap(width, height);
    test::fill(bitmap, {0, 0, width, height});
    return bitmap;
}

}  // namespace

TEST_CASE("scores are those of the definition, segment by segment", "[unit]") {
    int of_each[11] = {};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const RandomStream random(seed, "segments");
        // From scattered pixels to nearly all dark, and shapes as dilation makes them.
        const Bitmap source = dilate(test::random_bitmap(53, 47, random.uniform(0, 0.005, 0.08), 2 * seed), 7);
        const Bitmap target =
            dilate(test::random_bitmap(53, 47, random.uniform(1, 0.002, 0.05), 2 * seed + 1), 7);
        for (std::uint64_t i = 0; i < 50; ++i) {
            const std::uint64_t n = 2 + 4 * i;
            const Spot a{random.uniform(n, -8, 61), random.uniform(n + 1, -8, 55)};
            const Spot b{a.x + random.uniform(n + 2, -15, 15), a.y + random.uniform(n + 3, -15, 15)};
            const int score = match_score(source, target, a, b);
            CHECK(score == test::plain_score(source, target, a, b));
            ++of_each[score];
        }
    }
    for (int score = kLeastScore; score <= kBestScore; ++score) CHECK(of_each[score] > 0);
}

TEST_CASE("the score is the share of the strip that the target covers, in tenths", "[unit]") {
    const Bitmap source = filled(40, 40);
    // Ten columns of five pixels.
    const Spot a{10, 20.5}, b{20, 20.5};
    for (std::uint32_t columns = 0; columns <= 10; ++columns) {
        Bitmap target(40, 40);
        test::fill(target, {10, 0, 10 + columns, 40});
        CHECK(match_score(source, target, a, b) == std::max(1, static_cast<int>(columns)));
        CHECK(match_score(source, target, b, a) == std::max(1, static_cast<int>(columns)));
    }
    Bitmap rows(40, 40);
    test::fill(rows, {0, 18, 40, 20});  // two of five
    CHECK(match_score(source, rows, a, b) == 4);
}

TEST_CASE("more target than source is the best score, no source the least", "[unit]") {
    Bitmap thin(40, 40);
    test::fill(thin, {0, 20, 40, 21});
    CHECK(match_score(thin, filled(40, 40), {10, 20.5}, {20, 20.5}) == kBestScore);
    CHECK(match_score(Bitmap(40, 40), filled(40, 40), {10, 20.5}, {20, 20.5}) == kLeastScore);
    CHECK(match_score(filled(40, 40), filled(40, 40), {10, -20}, {20, -20}) == kLeastScore);
    CHECK(match_score(filled(40, 40), filled(40, 40), {10, 20}, {10, 20}) == kLeastScore);
}
