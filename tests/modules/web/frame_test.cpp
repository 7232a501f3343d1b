#include <catch2/catch.hpp>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

Layout frame_of(const std::vector<Vec3>& anchors, const Construction& how) {
    Layout layout;
    Jitter even(RandomStream(0, ""), 0);
    const Site site = web::test::site_of(anchors);
    layout.plane = site.plane;
    lay_frame(site, how, even, layout);
    return layout;
}

}  // namespace

TEST_CASE("inner frame points lie a fixed amount inside their anchors", "[unit]") {
    Construction how;
    how.inward_pull = 0;
    const Layout layout = frame_of(web::test::circle(10, 0.3), how);
    for (const std::size_t corner : layout.corners)
        CHECK(norm(layout.positions[layout.frame[corner]]) == Approx(0.25));
    CHECK(std::count(layout.fixed.begin(), layout.fixed.end(), 1) == 10);
}

TEST_CASE("inner frame points never pass half the way to the center", "[unit]") {
    const Layout layout = frame_of(web::test::circle(4, 0.04), {});
    for (const std::size_t corner : layout.corners)
        CHECK(norm(layout.positions[layout.frame[corner]]) == Approx(0.02));
}

TEST_CASE("the inward pull bends each segment to its sag", "[unit]") {
    Construction how;
    how.inward_pull = 0.1;
    const Layout layout = frame_of(web::test::circle(4, 0.3), how);
    const double side = 0.25 * std::sqrt(2.0);
    const std::size_t middle = layout.corners[1] / 2;
    REQUIRE(layout.corners[1] % 2 == 0);  // 18 pieces: there is a mass in the middle
    CHECK(norm(layout.positions[layout.frame[middle]]) == Approx(side / 2 - 0.1 * side));
}

TEST_CASE("masses are as far apart as the thesis places them", "[unit]") {
    Construction how;
    how.inward_pull = 0;
    const Layout layout = frame_of(web::test::circle(10, 0.3), how);
    for (const Piece& piece : layout.pieces) {
        const double length = distance(layout.positions[piece.a], layout.positions[piece.b]);
        if (piece.kind == Kind::anchor)
            CHECK(length == Approx(0.005));
        else
            CHECK(length == Approx(0.020).epsilon(0.1));
    }
}
