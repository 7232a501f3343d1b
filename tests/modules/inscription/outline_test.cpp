#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "bitmaps.hpp"
#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

Bitmap letter() {
    Bitmap coverage(300, 300);
    test::fill(coverage, {100, 50, 200, 110});
    return coverage;
}

/// Pixels from the letter as it is dilated, in the larger of both directions; below 0 inside.
double outside(const Spot& spot) { return std::max({97 - spot.x, spot.x - 203, 47 - spot.y, spot.y - 113}); }

}  // namespace

TEST_CASE("removal comes first, and what stays is denser around letters alone", "[unit]") {
    const test::HandMade web = test::make_orb(32, 16);
    const Page page = page_of(web, 300);
    const double mesh = web.mesh / page.pixel, shortest = 0.5 * mesh;
    for (const double outline : {1.0, 2.5}) {
        const test::Task task{web, page, letter(), {.width = 3.5, .outline = outline}};
        const WebChange change = task.write(strengthen_outline);
        CHECK(change.removed == task.write(remove_matches).removed);
        CHECK(change.added.empty());
        std::map<std::uint32_t, std::vector<WebChange::Thickened>> parts;
        for (const WebChange::Thickened& part : change.thickened) {
            CHECK(part.width == 3.5);
            parts[part.segment].push_back(part);
        }
        const std::set<std::uint32_t> removed(change.removed.begin(), change.removed.end());
        const double reach = std::ceil(outline * mesh);
        std::size_t within = 0;
        for (std::uint32_t i = 0; i < web.segments.size(); ++i) {
            const Spot a = page.spot(web.points[web.segments[i].a]),
                       b = page.spot(web.points[web.segments[i].b]);
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            for (double share = 0.5 / length; share < 1; share += 1 / length) {
                const double beside = outside({std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share)});
                bool thick = false;
                for (const WebChange::Thickened& part : parts[i])
                    thick |= share >= part.from && share <= part.to;
                // Runs shorter than `shortest` may be overlooked, and no longer ones.
                if (beside < -shortest || beside > reach + shortest) CHECK_FALSE(thick);
                if (beside > shortest && beside < reach - shortest && length > 2 * shortest &&
                    !removed.contains(i)) {
                    ++within;
                    CHECK(thick);
                }
            }
            if (removed.contains(i)) CHECK(parts[i].empty());
        }
        CHECK(within > (outline > 2 ? 50 : 0));
    }
}

TEST_CASE("an outline of no width is none", "[unit]") {
    const test::HandMade web = test::make_orb(32, 16);
    const test::Task task{web, page_of(web, 300), letter(), {.outline = 0}};
    CHECK(task.write(strengthen_outline).thickened.empty());
}
