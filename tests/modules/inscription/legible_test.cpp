#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "legibility.hpp"
#include "naturalness.hpp"
#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

constexpr std::uint32_t kSide = 240;

/// 48 radii and 20 turns: a mesh is 5 pixels.
test::HandMade orb() { return test::make_orb(48, 20); }

/// Strokes of three meshes, above the hub.
Bitmap letter() {
    Bitmap coverage(kSide, kSide);
    test::fill(coverage, {80, 30, 95, 90});
    test::fill(coverage, {95, 30, 160, 45});
    test::fill(coverage, {95, 75, 160, 90});
    return coverage;
}

struct Written {
    WebChange change;
    double share;  ///< of silk
    Legibility read;
};

Written write(const test::HandMade& web, const Bitmap& coverage, const ModeSettings& settings) {
    const Page page = page_of(web, kSide);
    const WebChange change = test::Task{web, page, coverage, settings}.write(write_legibly);
    const test::HandMade after = test::changed(web, change);
    const Lettering lettering{
        page, coverage, {dark_box(coverage.values, kSide, {0, 0, kSide, kSide})}, web.mesh};
    return {change, compare(web, change, after).silk_share,
            measure_legibility(after.points, after.segments, lettering)};
}

/// Samples a part of a thread: nothing is bright along `shortest` pixels.
void check_within(const Bitmap& coverage, const Spot& a, const Spot& b, double from, double to,
                  double shortest) {
    constexpr double kStep = 0.1;  // pixels
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double bright = 0;
    for (double share = from; share < to; share += kStep / length) {
        const auto x = static_cast<std::uint32_t>(std::lerp(a.x, b.x, share)),
                   y = static_cast<std::uint32_t>(std::lerp(a.y, b.y, share));
        bright = coverage.row(y)[x] != 0 ? 0 : bright + kStep;
        CHECK(bright < shortest + 2 * kStep);
    }
}

bool is_empty(const WebChange& change) {
    return change.removed.empty() && change.added.empty() && change.thickened.empty();
}

}  // namespace

TEST_CASE("no more silk is added than may be", "[unit]") {
    const test::HandMade web = orb();
    Bitmap corner(kSide, kSide);  // mostly beside the web: bare on average, and dense around its end
    test::fill(corner, {0, 0, 100, 60});
    for (const Bitmap& coverage : {letter(), corner})
        for (const double width : {2.0, 4.0, 12.0})
            for (const double loss : {0.0, 0.002, 0.03, 0.3}) {
                const Written found = write(web, coverage, {.width = width, .loss = loss});
                INFO("width " << width << ", loss " << loss);
                CHECK(found.share <= loss * (1 + 1e-6));  // widths are kept in single precision
                if (loss >= 0.03) CHECK(found.share > 0);
            }
}

TEST_CASE("threads are thickened within letters alone, to that width at most", "[unit]") {
    const test::HandMade web = orb();
    const Bitmap coverage = letter();
    const Page page = page_of(web, kSide);
    const double shortest = 0.5 * web.mesh / page.pixel;
    const WebChange change = write(web, coverage, {.width = 3, .loss = 0.3}).change;
    REQUIRE(change.thickened.size() > 20);
    for (const WebChange::Thickened& part : change.thickened) {
        CHECK(part.width > 1);
        CHECK(part.width <= 3);
        const ThreadSegment& thread = web.segments[part.segment];
        CHECK((thread.kind == test::kSpiral || thread.kind == test::kRadius));
        const Spot a = page.spot(web.points[thread.a]), b = page.spot(web.points[thread.b]);
        check_within(coverage, a, b, part.from, part.to, shortest);
    }
    for (const WebChange::Added& thread : change.added) {
        CHECK(thread.width > 0);
        CHECK(thread.width <= 3);
    }
}

TEST_CASE("parts of a thread are in order and do not overlap", "[unit]") {
    // Bars narrower than threads are long: most threads have two parts or more.
    const test::HandMade web = test::make_orb(10, 30);
    Bitmap bars(kSide, kSide);
    for (std::uint32_t x = 60; x < 180; x += 16) test::fill(bars, {x, 20, x + 8, 220});
    const WebChange change = write(web, bars, {.width = 4, .loss = 0.5}).change;
    std::vector<double> end(web.segments.size(), 0);
    std::size_t further = 0;
    for (const WebChange::Thickened& part : change.thickened) {
        CHECK(part.from >= end[part.segment]);
        CHECK(part.to > part.from);
        CHECK(part.to <= 1);
        further += end[part.segment] > 0 ? 1 : 0;
        end[part.segment] = part.to;
    }
    CHECK(further > 20);
}

TEST_CASE("threads are added within letters, between neighboring radii where the spiral has none", "[unit]") {
    const test::HandMade web = orb();
    const Page page = page_of(web, kSide);
    const double shortest = 0.5 * web.mesh / page.pixel;
    WebChange gap;  // across both strokes, and what lies between and around them
    for (std::uint32_t i = 0; i < web.segments.size(); ++i) {
        const Spot a = page.spot(web.points[web.segments[i].a]);
        if (web.segments[i].kind == test::kSpiral && a.x > 105 && a.x < 150 && a.y > 20 && a.y < 100)
            gap.removed.push_back(i);
    }
    const test::HandMade bare = test::changed(web, gap);
    const Bitmap coverage = letter();
    double widest = 0;
    for (const double width : {1.5, 4.0}) {
        const WebChange change = write(bare, coverage, {.width = width, .loss = 1}).change;
        CHECK(change.added.size() > 5);
        for (const WebChange::Added& thread : change.added) {
            CHECK(std::any_of(gap.removed.begin(), gap.removed.end(), [&](std::uint32_t i) {
                return std::minmax(web.segments[i].a, web.segments[i].b) == std::minmax(thread.a, thread.b);
            }));
            CHECK(bare.segments[thread.like].kind == test::kSpiral);
            CHECK(thread.width <= width);
            widest = std::max(widest, thread.width / width);
            check_within(coverage, page.spot(web.points[thread.a]), page.spot(web.points[thread.b]), 0, 1,
                         shortest);
        }
    }
    CHECK(widest == 1);
}

TEST_CASE("the more may be lost, the better it is read", "[unit]") {
    const test::HandMade web = orb();
    const double plain = write(web, letter(), {.loss = 0}).read.iou;
    double last = plain;
    for (const double loss : {0.01, 0.02, 0.05, 0.1, 0.2, 0.4}) {
        const double iou = write(web, letter(), {.width = 4, .loss = loss}).read.iou;
        CHECK(iou >= last - 0.01);  // a hundredth of the letter's pixels, at edges
        last = iou;
    }
    CHECK(last > plain + 0.3);
    CHECK(last > 0.8);
}

TEST_CASE("nothing is changed where nothing is to be written", "[unit]") {
    const test::HandMade web = orb();
    CHECK(
        is_empty(test::Task{web, page_of(web, kSide), Bitmap(kSide, kSide), {.loss = 1}}.write(write_legibly)));
    CHECK(is_empty(write(orb(), letter(), {.loss = 0}).change));
}

TEST_CASE("what is written legibly is the same again", "[unit]") {
    const Written one = write(orb(), letter(), {.loss = 0.1}), other = write(orb(), letter(), {.loss = 0.1});
    CHECK(one.change.removed == other.change.removed);
    REQUIRE(one.change.thickened.size() == other.change.thickened.size());
    for (std::size_t i = 0; i < one.change.thickened.size(); ++i) {
        CHECK(one.change.thickened[i].segment == other.change.thickened[i].segment);
        CHECK(one.change.thickened[i].width == other.change.thickened[i].width);
    }
    CHECK(one.read.iou == other.read.iou);
}
