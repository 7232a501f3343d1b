#include <catch2/catch.hpp>
#include <set>

#include "bitmaps.hpp"
#include "orbs.hpp"
#include "plain_score.hpp"
#include "source_picture.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

WebChange hatched(const test::HandMade& web, const Bitmap& coverage, int threshold) {
    return test::Task{web, page_of(web, coverage.width), coverage, {.score_threshold = threshold}}.write(
        crosshatch);
}

/// A spiral of one walk over points along an arc.
test::HandMade walk(std::uint32_t points) {
    test::HandMade web;
    web.mesh = 0.1;
    for (std::uint32_t i = 0; i < points; ++i) web.points.push_back({0.1 * i, 0.01 * i * i, 0});
    for (std::uint32_t i = 0; i + 1 < points; ++i) web.join(i, i + 1, test::kSpiral);
    return web;
}

}  // namespace

TEST_CASE("each mass of a walk is joined to the second and the third behind it", "[unit]") {
    const test::HandMade web = walk(6);
    const WebChange change = hatched(web, Bitmap(50, 50), 0);  // every score is above
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const WebChange::Added& thread : change.added) {
        CHECK(found.insert({thread.a, thread.b}).second);
        CHECK(thread.like == thread.a);  // the thread that begins there
        CHECK(thread.width == 1);
    }
    CHECK(found == decltype(found){{0, 2}, {0, 3}, {1, 3}, {1, 4}, {2, 4}, {2, 5}, {3, 5}});
    CHECK(change.removed.empty());
    CHECK(change.thickened.empty());
}

TEST_CASE("masses of different walks are not joined, nor any twice", "[unit]") {
    test::HandMade web = walk(4);
    web.join(0, 2, test::kStrand);  // is there already
    web.points.push_back({1, 1, 0});
    web.points.push_back({1.1, 1, 0});
    web.points.push_back({1.2, 1, 0});
    web.join(4, 5, test::kSpiral);
    web.join(5, 6, test::kSpiral);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const WebChange::Added& thread : hatched(web, Bitmap(50, 50), 0).added)
        found.insert({thread.a, thread.b});
    CHECK(found == decltype(found){{0, 3}, {1, 3}, {4, 6}});
}

TEST_CASE("of an orb's rings, those threads stay that match the target beside all others", "[unit]") {
    const test::HandMade web = test::make_orb(10, 6);
    const WebChange all = hatched(web, Bitmap(300, 300), 0);
    CHECK(all.added.size() == 6 * (9 + 8));  // a ring is a walk of 11 masses, of which the first is the last
    Bitmap coverage(300, 300);
    test::fill(coverage, {60, 20, 230, 120});
    const Page page = page_of(web, 300);
    const Bitmap source = source_picture(web, page, all.added), dilated = dilate(coverage, kDilation);
    for (const int threshold : {3, 8}) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, found;
        for (const WebChange::Added& thread : all.added)
            if (test::plain_score(source, dilated, page.spot(web.points[thread.a]),
                                  page.spot(web.points[thread.b])) > threshold)
                expected.emplace_back(thread.a, thread.b);
        for (const WebChange::Added& thread : hatched(web, coverage, threshold).added)
            found.emplace_back(thread.a, thread.b);
        CHECK(found == expected);
        CHECK(found.size() > 3);
        CHECK(found.size() < all.added.size());
    }
}
