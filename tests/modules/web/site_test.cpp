#include "site.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

TEST_CASE("unsound anchors are refused in words", "[unit]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Case {
        const char* name;
        std::vector<Vec3> anchors;
        std::optional<Vec3> center;
        std::string expected;
    };
    const std::vector<Case> cases = {
        {"none",
         {},
         {},
         "the web has 0 anchors; expected 3 to 1000; give the points it hangs from, in order around it"},
        {"one",
         {{0, 0, 0}},
         {},
         "the web has 1 anchor; expected 3 to 1000; give the points it hangs from, in order around it"},
        {"too many",
         std::vector<Vec3>(1001),
         {},
         "the web has 1001 anchors; expected 3 to 1000; give the points it hangs from, in order around it"},
        {"not a number",
         {{0, 0, 0}, {1, nan, 0}, {0, 1, 0}},
         {},
         "anchor 2 at (1, nan, 0) m is not a point; expected finite coordinates"},
        {"coincident",
         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}},
         {},
         "anchor 2 at (1, 0, 0) m and anchor 4 at (1, 0, 0) m coincide; expected anchors in different places; "
         "move or remove one of them"},
        {"all in one place",
         {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
         {},
         "anchor 1 at (1, 1, 1) m and anchor 2 at (1, 1, 1) m coincide; expected anchors in different places; "
         "move or remove one of them"},
        {"collinear",
         {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}},
         {},
         "the 3 anchors lie on one line; expected anchors all around an area; move at least one of them off "
         "the line"},
        {"crossing",
         {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
         {},
         "the frame thread from anchor 1 at (0, 0, 0) m to anchor 2 crosses the one from anchor 3 at (1, 0, 0) "
         "m to anchor 4; expected anchors in order around the web; list them in the order of a walk around it"},
        {"center outside",
         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
         Vec3{2, 2, 0},
         "the web's center at (2, 2, 0) m does not see the frame thread from anchor 2 at (1, 0, 0) m to anchor "
         "3 from inside; expected anchors all around the center; move those anchors outwards, or choose "
         "another 'center'"},
        {"center outside, anchors clockwise",
         {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},
         Vec3{2, 0.5, 0},
         "the web's center at (2, 0.5, 0) m does not see the frame thread from anchor 3 at (1, 1, 0) m to "
         "anchor 4 from inside; expected anchors all around the center; move those anchors outwards, or choose "
         "another 'center'"},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        Diagnostics faults;
        CHECK_FALSE(survey(c.anchors, c.center, faults));
        REQUIRE_FALSE(faults.empty());
        CHECK_THAT(to_string(faults.front()), Catch::EndsWith(c.expected));
    }
}

TEST_CASE("the center is the middle of the bounding box of the anchors", "[unit]") {
    const Site site = web::test::site_of({{-1, -1, 0}, {3, -1, 0}, {3, 1, 0}, {1, 2, 0}, {-1, 1, 0}});
    CHECK(distance(site.center, {1, 0.5, 0}) < 1e-12);
}

TEST_CASE("a triangle whose box has its middle on a side is centered on its centroid", "[unit]") {
    const Site site = web::test::site_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(distance(site.center, {1.0 / 3, 1.0 / 3, 0}) < 1e-12);
}

TEST_CASE("anchors given clockwise are turned around", "[unit]") {
    auto anchors = web::test::circle(5, 1);
    const Site straight = web::test::site_of(anchors);
    std::reverse(anchors.begin() + 1, anchors.end());
    CHECK(web::test::site_of(anchors).anchors == straight.anchors);
}
