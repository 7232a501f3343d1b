#include "legibility.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "ink.hpp"
#include "low_pass.hpp"
#include "orbs.hpp"
#include "otsu.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

constexpr std::uint32_t kSide = 160;

/// Pixels of 1 mm.
Page page() { return {{0.08, 0.08, 0}, {1, 0, 0}, {0, 1, 0}, 0.001, kSide}; }

/// Large letters, whose edges are short against what they hold.
Bitmap letters() {
    Bitmap coverage(kSide, kSide);
    test::fill(coverage, {24, 24, 64, 136});
    test::fill(coverage, {64, 96, 136, 136});
    return coverage;
}

Lettering lettering_of(const Bitmap& coverage, double blur = 0.004) {
    return {page(), coverage, {dark_box(coverage.values, kSide, {0, 0, kSide, kSide})}, blur};
}

/// Level threads through every `apart`-th row of pixels, of some width where pixels are dark and another
/// elsewhere.
test::HandMade written(const Bitmap& coverage, std::uint32_t apart, double dark, double bright) {
    test::HandMade web;
    const Page on = page();
    for (std::uint32_t y = apart / 2; y < kSide; y += apart)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const double width = coverage.row(y)[x] != 0 ? dark : bright;
            if (width == 0) continue;
            const auto a = static_cast<std::uint32_t>(web.points.size());
            web.points.push_back(on.point({static_cast<double>(x), y + 0.5}));
            web.points.push_back(on.point({x + 1.0, y + 0.5}));
            web.join(a, a + 1, test::kSpiral, width);
        }
    return web;
}

Legibility measure(const test::HandMade& web, const Lettering& lettering) {
    return measure_legibility(web.points, web.segments, lettering);
}

}  // namespace

// An edge that is blurred by 4 pixels is told to about a pixel; the letters' are 530 pixels long, around and
// within 7360 dark ones, and only corners are mistaken in one direction.
TEST_CASE("dense parallel threads are read as they were written", "[unit]") {
    const Lettering lettering = lettering_of(letters());
    const Legibility found = measure(written(letters(), 4, 4, 1), lettering);
    CHECK(found.iou > 0.95);
    CHECK(found.ssim > 0.9);
    CHECK(found.contrast == Approx(4).epsilon(1e-3));
}

TEST_CASE("ink that is the coverage itself is as similar as can be", "[unit]") {
    const Legibility found = measure(written(letters(), 1, 1, 0), lettering_of(letters()));
    CHECK(found.ssim == Approx(1).margin(1e-4));
    CHECK(found.iou > 0.95);
}

TEST_CASE("the negative of a picture is read as well as the picture", "[unit]") {
    const Lettering lettering = lettering_of(letters());
    const Legibility positive = measure(written(letters(), 4, 4, 1), lettering),
                     negative = measure(written(letters(), 4, 1, 4), lettering);
    CHECK(negative.contrast == Approx(0.25).epsilon(1e-3));
    CHECK(negative.iou == Approx(positive.iou).margin(1e-3));
    CHECK(negative.ssim == Approx(positive.ssim).margin(1e-3));
    const Legibility taken = measure(written(letters(), 4, 0, 1), lettering);
    CHECK(taken.contrast == 0);
    CHECK(taken.iou == Approx(positive.iou).margin(1e-3));
}

TEST_CASE("a web that nothing is written in has no contrast, and is not to be read", "[unit]") {
    const Legibility found = measure(written(letters(), 4, 1, 1), lettering_of(letters()));
    CHECK(found.contrast == Approx(1).epsilon(0.01));  // rows of threads are not cut evenly by letters
    CHECK(found.iou < 0.6);
    CHECK(found.ssim < 0.5);
}

TEST_CASE("without threads there is nothing to be read, and without blocks nothing to be measured", "[unit]") {
    const Legibility blank = measure({}, lettering_of(letters()));
    CHECK(blank.iou == 0);
    CHECK(blank.contrast == 1);
    CHECK(std::isfinite(blank.ssim));
    CHECK(blank.ssim < 0.5);
    Lettering nothing = lettering_of(letters());
    nothing.blocks.clear();
    const Legibility none = measure(written(letters(), 4, 4, 1), nothing);
    CHECK(none.iou == 0);
    CHECK(none.ssim == 0);
    CHECK(none.contrast == 1);
}

TEST_CASE("each block is parted by a threshold of its own", "[unit]") {
    Bitmap coverage(kSide, kSide);
    test::fill(coverage, {30, 16, 130, 56});
    Lettering lettering = lettering_of(coverage);
    const test::HandMade upper = written(coverage, 4, 2, 1);
    Bitmap lower(kSide, kSide);
    test::fill(lower, {30, 100, 130, 144});
    const test::HandMade dense = written(lower, 4, 20, 10);
    // The upper half of one web, the lower half of the other.
    test::HandMade web = upper;
    web.segments.clear();
    const auto offset = static_cast<std::uint32_t>(web.points.size());
    web.points.insert(web.points.end(), dense.points.begin(), dense.points.end());
    for (ThreadSegment each : upper.segments)
        if (upper.points[each.a].y > 0.08) web.segments.push_back(each);
    for (ThreadSegment each : dense.segments)
        if (dense.points[each.a].y < 0.08)
            web.segments.push_back({each.a + offset, each.b + offset, each.kind, each.width});
    test::fill(lettering.coverage, {30, 100, 130, 144});
    lettering.blocks = {{30, 16, 130, 56}, {30, 100, 130, 144}};
    // Bars of 40 pixels, told to a pixel or so along their edges; with one threshold the upper one is lost.
    CHECK(measure(web, lettering).iou > 0.85);
}

TEST_CASE("what is measured of a block is as if the whole page were blurred", "[unit]") {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const test::HandMade web = test::random_web(60, 150, seed);
        Bitmap coverage = test::random_bitmap(kSide, kSide, 0.001, seed);
        coverage = dilate(coverage, 15);
        const Box block = dark_box(coverage.values, kSide, {40, 30, 100, 90});
        REQUIRE_FALSE(block.empty());
        const Lettering lettering{page_of(web, kSide), coverage, {block}, 5 * page_of(web, kSide).pixel};
        const Shades seen = ink(web.points, web.segments, lettering.page), blurred = low_pass(seen, 5);
        const Box box{block.left - 5, block.top - 5, block.right + 5, block.bottom + 5};
        double silk[2] = {}, pixels[2] = {};
        float low = 1e9F, high = -1e9F;
        for (std::uint32_t y = box.top; y < box.bottom; ++y)
            for (std::uint32_t x = box.left; x < box.right; ++x) {
                const std::uint8_t dark = coverage.row(y)[x];
                silk[dark] += seen.row(y)[x];
                pixels[dark] += 1;
                low = std::min(low, blurred.row(y)[x]);
                high = std::max(high, blurred.row(y)[x]);
            }
        const double contrast = (silk[1] / pixels[1]) / (silk[0] / pixels[0]);
        Shades within(box.right - box.left, box.bottom - box.top);
        for (std::uint32_t y = 0; y < within.height; ++y)
            for (std::uint32_t x = 0; x < within.width; ++x) {
                const float stretched = (blurred.row(box.top + y)[box.left + x] - low) / (high - low);
                within.row(y)[x] = contrast < 1 ? 1 - stretched : stretched;
            }
        const double threshold = otsu_threshold(within).value();
        double both = 0, either = 0;
        for (std::uint32_t y = 0; y < within.height; ++y)
            for (std::uint32_t x = 0; x < within.width; ++x) {
                const bool read = within.row(y)[x] >= threshold,
                           asked = coverage.row(box.top + y)[box.left + x] != 0;
                both += read && asked ? 1 : 0;
                either += read || asked ? 1 : 0;
            }
        const Legibility found = measure(web, lettering);
        CHECK(found.contrast == Approx(contrast).epsilon(1e-6));
        // Single precision may move a pixel or two across the threshold.
        CHECK(found.iou == Approx(both / either).margin(3 / either));
    }
}

TEST_CASE("what is cut is missed", "[unit]") {
    Lettering lettering = lettering_of(letters());
    CHECK(lettering.cut_share() == 0);
    const test::HandMade web = written(letters(), 4, 4, 1);
    const Legibility whole = measure(web, lettering);
    lettering.cut = static_cast<double>(test::count_dark(letters()));
    CHECK(lettering.cut_share() == Approx(0.5));
    const Legibility half = measure(web, lettering);
    CHECK(half.iou < 0.5);
    CHECK(half.iou > 0.45 * whole.iou);
    CHECK(half.ssim == whole.ssim);
    CHECK(half.contrast == whole.contrast);
}
