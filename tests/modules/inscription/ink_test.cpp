#include "ink.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

double sum(const Shades& shades) { return std::accumulate(shades.values.begin(), shades.values.end(), 0.0); }

/// A page of pixels of 1 m, so that points are spots but for y, which is up.
Page unit_page(std::uint32_t side) { return {{0.5 * side, -0.5 * side, 0}, {1, 0, 0}, {0, 1, 0}, 1, side}; }

Shades ink_of(const Spot& a, const Spot& b, float width, std::uint32_t side) {
    const std::vector<Vec3> points = {{a.x, -a.y, 0}, {b.x, -b.y, 3}};
    const std::vector<ThreadSegment> threads = {{0, 1, 0, width}};
    return ink(points, threads, unit_page(side));
}

}  // namespace

// Single precision: a pixel adds up some ten threads, each rounded by 6e-8.
TEST_CASE("a page shows all silk of its web: lengths times widths", "[unit]") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        const test::HandMade web = test::random_web(40, 120, seed);
        const Page page = page_of(web, 100);
        double silk = 0;
        for (const ThreadSegment& thread : web.segments)
            silk += thread.width * distance(web.points[thread.a], web.points[thread.b]) / page.pixel;
        CHECK(sum(ink(web.points, web.segments, page)) == Approx(silk).epsilon(1e-5));
    }
}

TEST_CASE("each pixel has the silk that runs through it", "[unit]") {
    const test::HandMade web = test::random_web(12, 30, 5);
    const Page page = page_of(web, 15);
    const Shades seen = ink(web.points, web.segments, page);
    for (std::uint32_t y = 0; y < 15; ++y)
        for (std::uint32_t x = 0; x < 15; ++x) {
            // A page of that pixel alone.
            const Page one{page.point({x + 0.5, y + 0.5}), page.right, page.up, page.pixel, 1};
            double silk = 0;
            for (const ThreadSegment& thread : web.segments) {
                const Spot a = one.spot(web.points[thread.a]), b = one.spot(web.points[thread.b]);
                constexpr int kSamples = 20000;
                int within = 0;
                for (int i = 0; i < kSamples; ++i) {
                    const double share = (i + 0.5) / kSamples;
                    const double u = std::lerp(a.x, b.x, share), v = std::lerp(a.y, b.y, share);
                    within += u >= 0 && u < 1 && v >= 0 && v < 1 ? 1 : 0;
                }
                silk += std::hypot(b.x - a.x, b.y - a.y) * thread.width * within / kSamples;
            }
            // Samples of threads of at most 21 pixels lie 1e-3 apart; a few threads of width 3 meet in a pixel.
            CHECK(seen.row(y)[x] == Approx(silk).margin(0.02));
        }
}

TEST_CASE("silk beside the page is not seen", "[unit]") {
    CHECK(sum(ink_of({-5, -1}, {20, -2}, 1, 10)) == 0);
    CHECK(sum(ink_of({-5, 5.5}, {5, 5.5}, 2, 10)) == Approx(10).epsilon(1e-6));
    CHECK(sum(ink_of({-5, 5.5}, {25, 5.5}, 1, 10)) == Approx(10).epsilon(1e-6));
    CHECK(sum(ink_of({-5, -5}, {15, 15}, 1, 10)) == Approx(10 * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("silk through corners and along borders of pixels is seen once", "[unit]") {
    const Shades diagonal = ink_of({8, 8}, {2, 2}, 3, 10);
    for (std::uint32_t y = 0; y < 10; ++y)
        for (std::uint32_t x = 0; x < 10; ++x)
            CHECK(diagonal.row(y)[x] ==
                  Approx(x == y && x >= 2 && x < 8 ? 3 * std::sqrt(2.0) : 0).margin(1e-6));
    CHECK(sum(ink_of({4, 1.25}, {4, 8.5}, 1, 10)) == Approx(7.25).epsilon(1e-6));
    CHECK(sum(ink_of({9.5, 4}, {0.5, 4}, 1, 10)) == Approx(9).epsilon(1e-6));
    CHECK(sum(ink_of({0, 0}, {0, 10}, 1, 10)) == Approx(10).epsilon(1e-6));
}

TEST_CASE("a thread towards the viewer, or of no length, has no silk to be seen", "[unit]") {
    CHECK(sum(ink_of({4.5, 4.5}, {4.5, 4.5}, 1, 10)) == 0);
}
