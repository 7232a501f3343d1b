#include "lettering.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "ink.hpp"
#include "orbs.hpp"
#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// 32 radii and 16 turns of 1 cm: the spiral reaches from 4 to 19 cm from the hub, the web to 20 cm.
test::HandMade orb() { return test::make_orb(32, 16); }

const Bitmap kTwoWords = test::drawn({
    "###.#.#.###",  //
    "#.#.#.#.#..",  //
    "#.#.#.#.##.",  //
    "###..#..###",  //
    "...........",  //
    "...........",  //
    ".#.#.###...",  //
    ".#.#.#.#...",  //
    ".#.#.#.#...",  //
    ".###.###...",  //
});

std::string refusal(const test::HandMade& web, const Bitmap& coverage, const WhereToWrite& where) {
    try {
        lay_on(web, test::target_of(coverage), where);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::invalid);
        return fault.what();
    }
    return "";
}

WhereToWrite best_place(double most_ink = 1) {
    WhereToWrite where;
    where.best_place = true;
    where.lines = 2;
    where.most_ink = most_ink;
    where.side = 200;
    return where;
}

double share_of_ink(const test::HandMade& web, const Lettering& lettering) {
    const Shades seen = ink(web.points, web.segments, lettering.page);
    double within = 0, all = 0;
    for (std::size_t i = 0; i < seen.values.size(); ++i) {
        within += static_cast<double>(lettering.coverage.values[i]) * seen.values[i];
        all += seen.values[i];
    }
    return within / all;
}

}  // namespace

TEST_CASE("a target is as large as the page and in its middle, unless said otherwise", "[unit]") {
    const test::HandMade web = orb();
    const Bitmap coverage = test::random_bitmap(60, 60, 0.1, 1);
    WhereToWrite where;
    where.side = 60;
    where.blur = 1.5;
    const Lettering lettering = lay_on(web, test::target_of(coverage), where);
    CHECK(lettering.coverage == coverage);
    CHECK(lettering.blur == Approx(0.015));
    CHECK(lettering.page.side == 60);
    REQUIRE(lettering.blocks.size() == 1);
    const Box dark = dark_box(coverage.values, 60, {0, 0, 60, 60});
    CHECK(lettering.blocks[0].left == dark.left);
    CHECK(lettering.blocks[0].bottom == dark.bottom);
}

TEST_CASE("position is right of and above the hub, size is the target's width", "[unit]") {
    test::HandMade web = orb();
    web.points.push_back(web.center - 0.5 * web.right);  // the hub is not in the page's middle
    Bitmap coverage(40, 20);
    test::fill(coverage, {0, 0, 40, 20});
    WhereToWrite where;
    where.position = {0.03, 0.08};
    where.size = 0.1;
    where.side = 700;  // of 1 mm
    const Lettering lettering = lay_on(web, test::target_of(coverage), where);
    REQUIRE(lettering.blocks.size() == 1);
    const Box& box = lettering.blocks[0];
    const Vec3 low = lettering.page.point({static_cast<double>(box.left), static_cast<double>(box.bottom)});
    const Vec3 high = lettering.page.point({static_cast<double>(box.right), static_cast<double>(box.top)});
    // Pixels count whose middles lie within.
    CHECK(low.x - web.center.x == Approx(0.03 - 0.05).margin(0.6e-3));
    CHECK(high.x - web.center.x == Approx(0.03 + 0.05).margin(0.6e-3));
    CHECK(low.y - web.center.y == Approx(0.08 - 0.025).margin(0.6e-3));
    CHECK(high.y - web.center.y == Approx(0.08 + 0.025).margin(0.6e-3));
    CHECK(test::count_dark(lettering.coverage) == static_cast<std::size_t>(box.width() * box.height()));
}

TEST_CASE("what lies beside the page is cut, and known to be", "[unit]") {
    const test::HandMade web = orb();  // on a page 0.4 m wide, the hub in its middle
    Bitmap coverage(40, 40);
    test::fill(coverage, {0, 0, 40, 40});
    WhereToWrite where;
    where.size = 0.1;
    where.side = 400;
    for (const auto& [position, share] : std::vector<std::pair<Spot, double>>{
             {{0, 0}, 0}, {{0, 0.15}, 0}, {{0, 0.175}, 0.25}, {{0.2, 0}, 0.5}, {{-0.2, -0.2}, 0.75}}) {
        where.position = position;
        CAPTURE(position.x, position.y);
        CHECK(lay_on(web, test::target_of(coverage), where).cut_share() == Approx(share).margin(0.02));
    }
}

TEST_CASE("the best place is on the spiral, above and below the hub, and no lower than can be read", "[unit]") {
    const test::HandMade web = orb();
    const Lettering lettering = lay_on(web, test::target_of(kTwoWords), best_place());
    REQUIRE(lettering.blocks.size() == 2);
    const Spot hub = lettering.page.spot(web.center);
    CHECK(lettering.blocks[0].bottom <= hub.y + 1);
    CHECK(lettering.blocks[1].top >= hub.y - 1);
    const double mesh = web.mesh / lettering.page.pixel;
    for (const Box& block : lettering.blocks) CHECK(block.height() >= 3 * mesh - 2);
    // The ground is told through a blur of a mesh, to half a mesh.
    std::size_t beside = 0;
    for (std::uint32_t y = 0; y < 200; ++y)
        for (std::uint32_t x = 0; x < 200; ++x) {
            const double from_hub = std::hypot(x + 0.5 - hub.x, y + 0.5 - hub.y) / mesh;
            if (lettering.coverage.row(y)[x] != 0 && (from_hub < 3 || from_hub > 20)) ++beside;
        }
    CHECK(static_cast<double>(beside) <= 0.01 * static_cast<double>(test::count_dark(lettering.coverage)));
}

TEST_CASE("the best place has no more ink than may be written with", "[unit]") {
    const test::HandMade web = orb();
    double last = 0;
    for (const double most_ink : {0.05, 0.1, 0.2}) {
        const Lettering lettering = lay_on(web, test::target_of(kTwoWords), best_place(most_ink));
        const double share = share_of_ink(web, lettering);
        // Reckoned by the mean of all ground, of which letters hit the denser or the thinner part.
        CHECK(share < 1.2 * most_ink);
        CHECK(share > last);
        last = share;
    }
}

TEST_CASE("what cannot be written is refused in words", "[unit]") {
    const test::HandMade web = orb();
    test::HandMade bare = orb();
    bare.mesh = 0;
    CHECK(refusal(bare, kTwoWords, {}).find("no spiral") != std::string::npos);
    WhereToWrite far_away;
    far_away.position = {5, 5};
    CHECK(refusal(web, kTwoWords, far_away).find("lies on the web") != std::string::npos);
    CHECK(refusal(web, Bitmap(20, 20), {}).find("lies on the web") != std::string::npos);
    CHECK(refusal(web, Bitmap(20, 20), best_place()).find("lies on the web") != std::string::npos);
    Bitmap long_line(410, 30);  // 27 meshes long where it is two high, 41 where it is three, on a web of 40
    test::fill(long_line, {0, 0, 410, 30});
    CHECK(refusal(web, long_line, best_place()).find("does not fit") != std::string::npos);
}
