#include "line.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

struct Line {
    Spot a, b;
};

Line random_line(std::uint64_t seed, double low, double high) {
    const RandomStream random(seed, "line");
    return {{random.uniform(0, low, high), random.uniform(1, low, high)},
            {random.uniform(2, low, high), random.uniform(3, low, high)}};
}

/// The share of a line within a square (Liang and Barsky 1984).
double share_within(const Line& line, double side) {
    double from = 0, to = 1;
    const auto clip = [&](double at, double way) {
        if (way == 0) {
            if (at < 0 || at > side) to = from;
            return;
        }
        from = std::max(from, std::min(-at / way, (side - at) / way));
        to = std::min(to, std::max(-at / way, (side - at) / way));
    };
    clip(line.a.x, line.b.x - line.a.x);
    clip(line.a.y, line.b.y - line.a.y);
    return std::max(to - from, 0.0);
}

struct Piece {
    std::uint32_t x, y;
    double from, to;
};

std::vector<Piece> pieces_of(const Line& line, std::uint32_t side) {
    std::vector<Piece> pieces;
    cut_at_pixels(side, side, line.a, line.b, [&](std::uint32_t x, std::uint32_t y, double from, double to) {
        pieces.push_back({x, y, from, to});
    });
    return pieces;
}

}  // namespace

TEST_CASE("a drawn line has one pixel in each column, or row where it is steep, and there it runs", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Line line = random_line(seed, -10, 50);
        const bool steep = std::abs(line.b.y - line.a.y) > std::abs(line.b.x - line.a.x);
        Bitmap bitmap(40, 40);
        draw_line(bitmap, line.a, line.b);
        for (std::uint32_t at = 0; at < 40; ++at) {
            std::vector<std::uint32_t> dark;
            for (std::uint32_t across = 0; across < 40; ++across)
                if ((steep ? bitmap.row(at)[across] : bitmap.row(across)[at]) != 0) dark.push_back(across);
            const double a = steep ? line.a.y : line.a.x, b = steep ? line.b.y : line.b.x;
            const double c = steep ? line.a.x : line.a.y, d = steep ? line.b.x : line.b.y;
            if (std::max(a, b) <= at || std::min(a, b) >= at + 1) {
                CHECK(dark.empty());
                continue;
            }
            const double middle = std::clamp(at + 0.5, std::min(a, b), std::max(a, b));
            const double there = std::lerp(c, d, (middle - a) / (b - a));
            if (there < 0 || there >= 40) {
                CHECK(dark.empty());
            } else {
                REQUIRE(dark.size() == 1);
                CHECK(dark[0] == static_cast<std::uint32_t>(there));
            }
        }
    }
}

TEST_CASE("short lines and level ones darken what they lie in", "[unit]") {
    Bitmap point(5, 5);
    draw_line(point, {2.5, 3.5}, {2.5, 3.5});
    CHECK(point == test::drawn({".....", ".....", ".....", "..#..", "....."}));
    Bitmap level(5, 3);
    draw_line(level, {3.2, 1.5}, {1.5, 1.5});
    CHECK(level == test::drawn({".....", ".###.", "....."}));
    Bitmap upright(3, 4);
    draw_line(upright, {1.5, -7}, {1.5, 2.5});
    CHECK(upright == test::drawn({".#.", ".#.", ".#.", "..."}));
    Bitmap beside(4, 4);
    draw_line(beside, {-3, 5}, {9, 4.5});
    CHECK(test::count_dark(beside) == 0);
}

// Shares of a line of some 40 pixels: rounding is below 1e-13, and crossings closer than 1e-9 count as one.
TEST_CASE("a line is cut at every side of a pixel that it crosses, and nothing of it is lost", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Line line = random_line(seed, 0.5, 39.5);
        const auto pieces = pieces_of(line, 40);
        const double sides = std::abs(std::floor(line.a.x) - std::floor(line.b.x)) +
                             std::abs(std::floor(line.a.y) - std::floor(line.b.y));
        CHECK(static_cast<double>(pieces.size()) == sides + 1);
        double at = 0;
        for (const Piece& piece : pieces) {
            CHECK(piece.from == at);
            CHECK(piece.to > piece.from);
            at = piece.to;
            for (const double share : {piece.from, piece.to}) {
                const double x = std::lerp(line.a.x, line.b.x, share), y = std::lerp(line.a.y, line.b.y, share);
                CHECK((x > piece.x - 1e-8 && x < piece.x + 1 + 1e-8));
                CHECK((y > piece.y - 1e-8 && y < piece.y + 1 + 1e-8));
            }
        }
        CHECK(at == 1);
    }
}

TEST_CASE("of a line partly beside a raster, what lies on it is left", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Line line = random_line(seed, -60, 100);
        double sum = 0;
        for (const Piece& piece : pieces_of(line, 40)) sum += piece.to - piece.from;
        CHECK(sum == Approx(share_within(line, 40)).margin(1e-8));
    }
}

TEST_CASE("a line through corners of pixels is cut there once", "[unit]") {
    for (const bool back : {false, true}) {
        const auto pieces = pieces_of(back ? Line{{9, 9}, {2, 2}} : Line{{2, 2}, {9, 9}}, 12);
        REQUIRE(pieces.size() == 7);
        for (std::size_t i = 0; i < 7; ++i) {
            CHECK(pieces[i].x == (back ? 8 - i : 2 + i));
            CHECK(pieces[i].y == pieces[i].x);
            CHECK(pieces[i].to - pieces[i].from == Approx(1.0 / 7).margin(1e-9));
        }
    }
}

TEST_CASE("a line along the border of pixels is within those right of it, or below", "[unit]") {
    const auto upright = pieces_of({{5, 2}, {5, 6}}, 12), level = pieces_of({{6.5, 5}, {2.5, 5}}, 12);
    REQUIRE(upright.size() == 4);
    for (const Piece& piece : upright) CHECK(piece.x == 5);
    REQUIRE(level.size() == 5);
    for (const Piece& piece : level) CHECK(piece.y == 5);
}

TEST_CASE("a line of no length has no pieces", "[unit]") {
    CHECK(pieces_of({{3.5, 3.5}, {3.5, 3.5}}, 12).empty());
}
