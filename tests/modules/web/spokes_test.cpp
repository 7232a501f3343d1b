#include <catch2/catch.hpp>
#include <set>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

TEST_CASE("every frame mass holds one spoke, which ends in the hub", "[unit]") {
    const Layout layout = web::test::thesis_layout();
    REQUIRE(layout.spokes.size() == layout.frame.size());
    const std::set<Index> hub(layout.hub.begin(), layout.hub.end());
    for (std::size_t s = 0; s < layout.spokes.size(); ++s) {
        CHECK(layout.spokes[s].front() == layout.frame[s]);
        CHECK(hub.count(layout.spokes[s].back()) == 1);
    }
}

TEST_CASE("the hub is a ring of masses at the hub radius", "[unit]") {
    const Layout layout = web::test::thesis_layout();
    CHECK(layout.hub.size() >= 10);
    for (const Index i : layout.hub) CHECK(distance(layout.positions[i], layout.center) == Approx(0.015));
    CHECK(norm(layout.center) < 0.02);
}

TEST_CASE("a hub too large for its web shrinks to a quarter of the way to the frame", "[unit]") {
    Construction how;
    how.hub_radius = 1;
    const Layout layout = construct(web::test::site_of(web::test::circle(6, 0.3)), how, RandomStream(1, ""));
    double nearest = 1;
    for (const Index i : layout.frame)
        nearest = std::min(nearest, distance(layout.positions[i], layout.center));
    CHECK(distance(layout.positions[layout.hub[0]], layout.center) == Approx(nearest / 4));
}

TEST_CASE("a center that the scene chose gets the hub", "[unit]") {
    Diagnostics faults;
    const Vec3 center{0.03, 0.02, 0};
    const auto site = survey(web::test::thesis_anchors(), center, faults);
    REQUIRE(site);
    CHECK(distance(construct(*site, {}, RandomStream(1, "")).center, center) < 1e-12);
}

TEST_CASE("symmetric anchors give no springs without length and no double ones", "[unit]") {
    for (const std::size_t count : {3, 4, 5, 6, 8, 10, 12}) {
        INFO(count << " anchors");
        const Layout layout =
            construct(web::test::site_of(web::test::circle(count, 0.3)), {}, RandomStream(1, ""));
        std::set<std::pair<Index, Index>> joined;
        for (const Piece& piece : layout.pieces) {
            CHECK(distance(layout.positions[piece.a], layout.positions[piece.b]) > 5e-4);
            CHECK(joined.insert(std::minmax(piece.a, piece.b)).second);
        }
    }
}
