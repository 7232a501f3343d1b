#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "orbs.hpp"
#include "plain_score.hpp"
#include "source_picture.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

TEST_CASE("those spiral threads are taken whose score is above the threshold", "[unit]") {
    std::size_t taken = 0, kept = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const test::HandMade web = seed % 2 == 0 ? test::random_web(40, 120, seed) : test::make_orb(16, 6);
        const Page page = page_of(web, 80);
        const Bitmap coverage = test::random_bitmap(80, 80, 0.01, seed);
        const Bitmap source = source_picture(web, page), dilated = dilate(coverage, kDilation);
        for (const int threshold : {2, 5, 8}) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < web.segments.size(); ++i) {
                if (web.segments[i].kind != test::kSpiral) continue;
                const Spot a = page.spot(web.points[web.segments[i].a]),
                           b = page.spot(web.points[web.segments[i].b]);
                if (test::plain_score(source, dilated, a, b) > threshold)
                    expected.push_back(i);
                else
                    ++kept;
            }
            taken += expected.size();
            const WebChange change =
                test::Task{web, page, coverage, {.score_threshold = threshold}}.write(remove_matches);
            CHECK(change.removed == expected);
            CHECK(change.added.empty());
            CHECK(change.thickened.empty());
        }
    }
    CHECK(taken > 100);
    CHECK(kept > 100);
}

TEST_CASE("no threshold takes all of the spiral, the highest none", "[unit]") {
    const test::HandMade web = test::make_orb(12, 5);
    Bitmap coverage(100, 100);
    test::fill(coverage, {0, 0, 100, 100});
    const Page page = page_of(web, 100);
    CHECK(test::Task{web, page, coverage, {.score_threshold = 0}}.write(remove_matches).removed.size() ==
          12 * 5);
    CHECK(test::Task{web, page, coverage, {.score_threshold = 9}}.write(remove_matches).removed.size() ==
          12 * 5);
    CHECK(test::Task{web, page, coverage, {.score_threshold = 10}}.write(remove_matches).removed.empty());
}
