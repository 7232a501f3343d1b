#include "placing.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bitmaps.hpp"
#include "dilate.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

Bitmap filled(std::uint32_t side) {
    Bitmap bitmap(side, side);
    test::fill(bitmap, {0, 0, side, side});
    return bitmap;
}

/// What an orb's spiral covers: a disc but for the hub.
Bitmap ring(std::uint32_t side, const Spot& hub, double hole, double radius) {
    Bitmap ground(side, side);
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const double half = 0.5 * side, from_middle = std::hypot(x + 0.5 - half, y + 0.5 - half);
            const double from_hub = std::hypot(x + 0.5 - hub.x, y + 0.5 - hub.y);
            ground.row(y)[x] = from_middle < radius && from_hub > hole ? 1 : 0;
        }
    return ground;
}

struct Lie {
    std::size_t dark = 0, beside = 0;
    std::uint32_t top = ~0U, bottom = 0;  ///< rows of the ground

    bool fits() const { return dark > 0 && static_cast<double>(beside) <= 0.005 * static_cast<double>(dark); }
};

/// How a block lies on the ground, found on a page with room around it.
Lie lie_of(const Target& target, Placement placed, const Bitmap& ground) {
    const std::uint32_t side = ground.width;
    placed.middle = {placed.middle.x + side, placed.middle.y + side};
    const Bitmap page = place(target, {placed}, 3 * side);
    Lie lie;
    for (std::uint32_t y = 0; y < 3 * side; ++y)
        for (std::uint32_t x = 0; x < 3 * side; ++x) {
            if (page.row(y)[x] == 0) continue;
            ++lie.dark;
            const bool seen = x >= side && y >= side && x < 2 * side && y < 2 * side;
            if (!seen || ground.row(y - side)[x - side] == 0) ++lie.beside;
            if (y < side) continue;
            lie.top = std::min(lie.top, y - side);
            lie.bottom = std::max(lie.bottom, y - side + 1);
        }
    return lie;
}

/// Tries every pixel as the block's middle.
bool fits_somewhere(const Target& target, const Box& block, double scale, const Bitmap& ground,
                    std::uint32_t top, std::uint32_t bottom) {
    for (std::uint32_t y = 0; y < ground.height; ++y)
        for (std::uint32_t x = 0; x < ground.width; ++x) {
            const Lie lie = lie_of(target, {block, {x + 0.5, y + 0.5}, scale}, ground);
            if (lie.fits() && lie.top >= top && lie.bottom <= bottom) return true;
        }
    return false;
}

const Bitmap kTwoLines = test::drawn({
    "...............",  //
    "..#.....#......",  // the dots of two letters
    "...............",  //
    "..#.##..#.###..",  //
    "..#.#.#.#.#.#..",  //
    "..#.#.#.#.###..",  //
    "...............",  //
    "...............",  //
    "#####..........",  //
    "..#..#######...",  //
    "..#..#.....#...",  //
    "...............",  //
});

}  // namespace

TEST_CASE("the whole target is placed by its width and its middle", "[unit]") {
    const Bitmap coverage(30, 20);
    const Placement placed = whole(test::target_of(coverage), {50, 60}, 45);
    CHECK(placed.scale == 1.5);
    CHECK(placed.block.right == 30);
    CHECK(placed.block.bottom == 20);
    const Box box = box_of(placed, 100);
    CHECK(box.left == 27);  // 27.5 to 72.5
    CHECK(box.right == 73);
    CHECK(box.top == 45);  // 45 to 75
    CHECK(box.bottom == 75);
    const Box cut = box_of(placed, 65);
    CHECK(cut.right == 65);
    CHECK(cut.bottom == 65);
    CHECK(box_of(whole(test::target_of(coverage), {-50, 60}, 45), 100).empty());
}

TEST_CASE("what is dark beside the page is counted in pixels of the page", "[unit]") {
    Bitmap coverage(30, 20);
    test::fill(coverage, {10, 0, 20, 20});
    const Target target = test::target_of(coverage);
    struct Case {
        Spot middle;
        double width, beside;
    };
    for (const auto& [middle, width, beside] : std::vector<Case>{{{50, 50}, 30, 0},
                                                                 {{50, 50}, 300, 10 * 10 * 100},
                                                                 {{50, 0}, 30, 100},
                                                                 {{100, 100}, 30, 150},
                                                                 {{-50, 50}, 60, 800}}) {
        CAPTURE(middle.x, middle.y, width);
        CHECK(dark_beside(target, whole(target, middle, width), 100) == Approx(beside));
    }
}

TEST_CASE("what is placed at its own size is copied, at twice its size doubled", "[unit]") {
    const Bitmap coverage = test::random_bitmap(20, 20, 0.3, 1);
    CHECK(place(test::target_of(coverage), {whole(test::target_of(coverage), {10, 10}, 20)}, 20) == coverage);
    const Bitmap twice = place(test::target_of(coverage), {whole(test::target_of(coverage), {20, 20}, 40)}, 40);
    for (std::uint32_t y = 0; y < 40; ++y)
        for (std::uint32_t x = 0; x < 40; ++x) CHECK(twice.row(y)[x] == coverage.row(y / 2)[x / 2]);
}

TEST_CASE("each pixel of the page is as the target at its middle, of any placement", "[unit]") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Bitmap coverage = test::random_bitmap(17, 13, 0.4, seed);
        const RandomStream random(seed, "places");
        const Placement placements[] = {
            {{2, 1, 9, 13}, {random.uniform(0, -5, 45), random.uniform(1, -5, 45)}, random.uniform(2, 0.3, 4)},
            {{9, 0, 17, 7}, {random.uniform(3, -5, 45), random.uniform(4, -5, 45)}, random.uniform(5, 0.3, 4)}};
        // From the target: the middles of pixels that each of its dark pixels spans.
        Bitmap expected(40, 40);
        for (const Placement& placed : placements)
            for (std::uint32_t v = placed.block.top; v < placed.block.bottom; ++v)
                for (std::uint32_t u = placed.block.left; u < placed.block.right; ++u) {
                    if (coverage.row(v)[u] == 0) continue;
                    const auto at = [&](double from, double half, double middle) {
                        return std::ceil(middle + (from - half) * placed.scale - 0.5);
                    };
                    const double half_width = 0.5 * placed.block.width(),
                                 half_height = 0.5 * placed.block.height();
                    const double column = u - placed.block.left, row = v - placed.block.top;
                    for (double y = at(row, half_height, placed.middle.y);
                         y < at(row + 1, half_height, placed.middle.y); ++y)
                        for (double x = at(column, half_width, placed.middle.x);
                             x < at(column + 1, half_width, placed.middle.x); ++x)
                            if (x >= 0 && y >= 0 && x < 40 && y < 40)
                                expected.row(static_cast<std::uint32_t>(y))[static_cast<std::uint32_t>(x)] = 1;
                }
        CHECK(place(test::target_of(coverage), {placements[0], placements[1]}, 40) == expected);
    }
}

TEST_CASE("one line is one block, as close as what is dark", "[unit]") {
    const auto blocks = blocks_of(test::target_of(kTwoLines), 1);
    REQUIRE(blocks.size() == 1);
    CHECK(blocks[0].left == 0);
    CHECK(blocks[0].right == 13);
    CHECK(blocks[0].top == 1);
    CHECK(blocks[0].bottom == 11);
    CHECK(blocks_of(test::target_of(Bitmap(9, 9)), 1).empty());
    CHECK(blocks_of(test::target_of(Bitmap(9, 9)), 2).empty());
}

TEST_CASE("lines part where the blank rows are most, and not between a letter and its dot", "[unit]") {
    const auto blocks = blocks_of(test::target_of(kTwoLines), 2);
    REQUIRE(blocks.size() == 2);
    CHECK(blocks[0].left == 2);
    CHECK(blocks[0].right == 13);
    CHECK(blocks[0].top == 1);
    CHECK(blocks[0].bottom == 6);
    CHECK(blocks[1].left == 0);
    CHECK(blocks[1].right == 12);
    CHECK(blocks[1].top == 8);
    CHECK(blocks[1].bottom == 11);
}

TEST_CASE("of an odd number of lines, the upper block has the middle one", "[unit]") {
    for (std::uint32_t lines = 2; lines <= 6; ++lines) {
        // Line i has dots over letters of i + 1 pixels, a blank row between them, and two blank rows below.
        Bitmap text(10, 5 * lines);
        for (std::uint32_t i = 0; i < lines; ++i) {
            test::fill(text, {0, 5 * i, 1, 5 * i + 1});
            test::fill(text, {0, 5 * i + 2, i + 1, 5 * i + 3});
        }
        const auto blocks = blocks_of(test::target_of(text), lines);
        REQUIRE(blocks.size() == 2);
        const std::uint32_t upper = (lines + 1) / 2;
        CHECK(blocks[0].bottom == 5 * upper - 2);
        CHECK(blocks[0].right == upper);
        CHECK(blocks[1].top == 5 * upper);
        CHECK(blocks[1].right == lines);
    }
}

TEST_CASE("lines that no blank rows part are one block", "[unit]") {
    const Bitmap text = test::drawn({"##..", "..##", "##.."});
    const auto blocks = blocks_of(test::target_of(text), 2);
    REQUIRE(blocks.size() == 1);
    CHECK(blocks[0].bottom == 3);
}

TEST_CASE("a block lies on writable ground, as large as fits", "[unit]") {
    const Spot hub{21, 18};
    const Bitmap ground = ring(40, hub, 6, 19);
    for (const auto& [width, height] : {std::pair{30U, 10U}, {10U, 10U}, {8U, 24U}}) {
        Bitmap coverage(width, height);
        test::fill(coverage, {0, 0, width, height});
        const Target target = test::target_of(coverage);
        const Box block{0, 0, width, height};
        const auto placed = best_placements(target, {block}, ground, hub, 0.1, 10);
        REQUIRE(placed);
        REQUIRE(placed->size() == 1);
        CHECK(lie_of(target, placed->front(), ground).fits());
        CHECK_FALSE(fits_somewhere(target, block, 1.05 * placed->front().scale, ground, 0, 40));
    }
}

TEST_CASE("two blocks lie one above and one below the hub, as large as both fit", "[unit]") {
    const Spot hub{21, 18};
    const Target target = test::target_of(kTwoLines);
    const auto blocks = blocks_of(target, 2);
    REQUIRE(blocks.size() == 2);
    for (const Bitmap& ground : {ring(40, hub, 6, 19), ring(40, hub, 0, 19), filled(40)}) {
        const auto placed = best_placements(target, blocks, ground, hub, 0.3, 10);
        REQUIRE(placed);
        REQUIRE(placed->size() == 2);
        const Placement &above = placed->front(), &below = placed->back();
        CHECK(above.scale == below.scale);
        CHECK(above.block.top == blocks[0].top);
        CHECK(below.block.top == blocks[1].top);
        const Lie upper = lie_of(target, above, ground), lower = lie_of(target, below, ground);
        CHECK(upper.fits());
        CHECK(lower.fits());
        CHECK(upper.bottom <= 18);
        CHECK(lower.top >= 18);
        const double larger = 1.05 * above.scale;
        CHECK_FALSE((fits_somewhere(target, blocks[0], larger, ground, 0, 18) &&
                     fits_somewhere(target, blocks[1], larger, ground, 18, 40)));
    }
}

TEST_CASE("at most one dark pixel in two hundred lies beside writable ground", "[unit]") {
    Bitmap coverage(10, 10);
    test::fill(coverage, {0, 0, 10, 10});
    const Target target = test::target_of(coverage);
    std::size_t beside = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Bitmap ground = test::random_bitmap(60, 60, 0.003, seed);
        for (std::uint8_t& each : ground.values) each ^= 1;
        const auto placed = best_placements(target, {{0, 0, 10, 10}}, ground, {30, 30}, 0.3, 10);
        REQUIRE(placed);
        const Lie lie = lie_of(target, placed->front(), ground);
        CHECK(lie.fits());
        beside += lie.beside;
    }
    CHECK(beside > 0);
}

TEST_CASE("of the places that do, the nearest to the hub's column is taken", "[unit]") {
    Bitmap coverage(5, 5);
    test::fill(coverage, {0, 0, 5, 5});
    Bitmap ground(40, 40);
    test::fill(ground, {2, 4, 14, 36});
    test::fill(ground, {26, 4, 38, 36});
    const auto place_by = [&](double column) {
        const auto placed =
            best_placements(test::target_of(coverage), {{0, 0, 5, 5}}, ground, {column, 20}, 1, 1);
        REQUIRE(placed);
        return placed->front().middle.x;
    };
    // Two pixels to each side of the middle one.
    CHECK(place_by(24) == 28.5);
    CHECK(place_by(15) == 11.5);
    CHECK(place_by(7.3) == 7.5);
}

TEST_CASE("in the hub's column, the place deepest inside is taken", "[unit]") {
    Bitmap coverage(5, 5);
    test::fill(coverage, {0, 0, 5, 5});
    Bitmap ground(40, 40);
    test::fill(ground, {0, 4, 40, 36});
    const auto placed = best_placements(test::target_of(coverage), {{0, 0, 5, 5}}, ground, {20, 8}, 1, 1);
    REQUIRE(placed);
    CHECK(placed->front().middle.x == 20.5);
    CHECK(std::abs(placed->front().middle.y - 20) == 0.5);  // rows 4 to 35 have two middles
}

TEST_CASE("no scale is above the most, and where the least does not fit there is no place", "[unit]") {
    Bitmap coverage(10, 10);
    test::fill(coverage, {0, 0, 10, 10});
    const Target target = test::target_of(coverage);
    const std::vector<Box> blocks = {{0, 0, 10, 10}};
    const auto placed = best_placements(target, blocks, filled(40), {20, 20}, 0.5, 1.5);
    REQUIRE(placed);
    CHECK(placed->front().scale <= 1.5);
    CHECK(placed->front().scale > 1.5 - 1e-3);  // 1 over twelve halvings
    CHECK_FALSE(best_placements(target, blocks, ring(40, {20, 20}, 8, 19), {20, 20}, 1.5, 3));
    CHECK_FALSE(best_placements(target, blocks, Bitmap(40, 40), {20, 20}, 0.2, 3));
}
