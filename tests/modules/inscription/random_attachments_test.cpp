#include <catch2/catch.hpp>
#include <set>

#include "bitmaps.hpp"
#include "orbs.hpp"
#include "plain_score.hpp"
#include "source_picture.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

Bitmap letter() {
    Bitmap coverage(150, 150);
    test::fill(coverage, {30, 20, 120, 60});
    return coverage;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> joined_by(const WebChange& change) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const WebChange::Added& thread : change.added) pairs.emplace_back(thread.a, thread.b);
    return pairs;
}

}  // namespace

TEST_CASE("so many threads are attached for each one taken", "[unit]") {
    const test::HandMade web = test::make_orb(24, 12);
    test::Task task{web, page_of(web, 150), letter(), {.score_threshold = 6, .width = 2.5}};
    const WebChange removal = task.write(remove_matches);
    REQUIRE(removal.removed.size() > 20);
    for (const double attachments : {0.0, 0.3, 1.0}) {
        task.settings.attachments = attachments;
        const WebChange change = task.write(attach_at_random);
        CHECK(change.removed == removal.removed);
        CHECK(change.added.size() ==
              static_cast<std::size_t>(attachments * 1.0 * static_cast<double>(removal.removed.size())));
        CHECK(change.thickened.empty());
    }
}

TEST_CASE("threads are attached within letters, short, new, darker and where they match", "[unit]") {
    const test::HandMade web = test::make_orb(24, 12);
    const test::Task task{web, page_of(web, 150), letter(), {.score_threshold = 6, .width = 2.5}};
    const WebChange change = task.write(attach_at_random);
    const std::set<std::uint32_t> removed(change.removed.begin(), change.removed.end());
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const ThreadSegment& thread : web.segments) joined.insert(std::minmax(thread.a, thread.b));
    const Bitmap source = source_picture(web, task.page), dilated = dilate(task.coverage, kDilation);
    REQUIRE_FALSE(change.added.empty());
    for (const WebChange::Added& thread : change.added) {
        const Spot a = task.page.spot(web.points[thread.a]), b = task.page.spot(web.points[thread.b]);
        for (const Spot& end : {a, b}) CHECK((end.x >= 30 && end.x < 120 && end.y >= 20 && end.y < 60));
        CHECK(distance(web.points[thread.a], web.points[thread.b]) <= (5 + 1e-9) * web.mesh);
        CHECK(joined.insert(std::minmax(thread.a, thread.b)).second);
        CHECK(test::plain_score(source, dilated, a, b) > 6);
        CHECK(thread.width == 2.5);
        CHECK(removed.contains(thread.like));
    }
}

TEST_CASE("no thread leads from a mass to itself, even where every score will do", "[unit]") {
    const test::HandMade web = test::make_orb(24, 12);
    const test::Task task{web, page_of(web, 150), letter(), {.score_threshold = 0}};
    const WebChange change = task.write(attach_at_random);
    CHECK(change.added.size() > 100);
    for (const WebChange::Added& thread : change.added) CHECK(thread.a != thread.b);
}

TEST_CASE("chance is the seed's", "[unit]") {
    const test::HandMade web = test::make_orb(24, 12);
    test::Task task{web, page_of(web, 150), letter(), {.score_threshold = 6}};
    const auto first = joined_by(task.write(attach_at_random));
    CHECK(joined_by(task.write(attach_at_random)) == first);
    task.seed = 2;
    CHECK(joined_by(task.write(attach_at_random)) != first);
}

TEST_CASE("where nothing is taken, or no two masses lie within, nothing is attached", "[unit]") {
    const test::HandMade web = test::make_orb(24, 12);
    test::Task task{web, page_of(web, 150), letter(), {.score_threshold = 10}};
    CHECK(task.write(attach_at_random).added.empty());
    // More is asked for than there are pairs of masses.
    task.settings.score_threshold = 6;
    task.settings.attachments = 20;
    const WebChange many = task.write(attach_at_random);
    CHECK(many.added.size() < 20 * many.removed.size());
    CHECK(many.added.size() > many.removed.size());
}
