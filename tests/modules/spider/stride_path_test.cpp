#include "stride_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::spider;

TEST_CASE("every path begins and ends on the ground, goes on without a jump, and rises to 1", "[unit]") {
    constexpr int kSteps = 10000;
    for (const StridePath& path : stride_paths()) {
        INFO(path.name);
        double highest = 0;
        SwingPoint before = path.point(0);
        CHECK(before.along == Approx(0).margin(1e-15));
        CHECK(before.height == Approx(0).margin(1e-15));
        for (int i = 1; i <= kSteps; ++i) {
            const SwingPoint point = path.point(static_cast<double>(i) / kSteps);
            CHECK(point.along >= before.along);
            CHECK(point.height >= 0);
            CHECK(std::abs(point.along - before.along) < 4.0 / kSteps);
            CHECK(std::abs(point.height - before.height) < 8.0 / kSteps);
            highest = std::max(highest, point.height);
            before = point;
        }
        CHECK(before.along == Approx(1).epsilon(1e-15));
        CHECK(before.height == Approx(0).margin(1e-15));
        CHECK(highest == Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("the cycloid is the path of a mark on a rolling wheel", "[unit]") {
    const StridePath& cycloid = *find_stride_path("cycloid");
    for (const double turn : {0.3, 1.0, 2.5, 4.0, 6.0}) {  // rad
        const SwingPoint point = cycloid.point(turn / (2 * M_PI));
        CHECK(point.along == Approx((turn - std::sin(turn)) / (2 * M_PI)).epsilon(1e-12));
        CHECK(point.height == Approx((1 - std::cos(turn)) / 2).epsilon(1e-12));
    }
}

TEST_CASE("a swing lies in the plane of its ends and their ups", "[unit]") {
    const StridePath& path = *find_stride_path("cycloid");
    // Round an outside edge: from a top face over to a side face.
    const Swing swing{{0.9, 1, 0.2}, {1, 0.9, 0.2}, {0, 1, 0}, {1, 0, 0}, 0.05};
    CHECK(foot_at(path, swing, 0) == swing.start);
    CHECK(foot_at(path, swing, 1) == swing.end);
    const Vec3 middle = foot_at(path, swing, 0.5);
    CHECK(middle.z == 0.2);
    const Vec3 over = middle - 0.5 * (swing.start + swing.end);
    CHECK(norm(over) == Approx(0.05).epsilon(1e-12));
    CHECK(over.x == Approx(over.y).epsilon(1e-12));  // outwards, between both ups
    CHECK(over.x > 0);
}

TEST_CASE("swings that go nowhere, or whose ups say nothing, have places all the same", "[unit]") {
    const StridePath& path = *find_stride_path("arc");
    const Swing up_and_down{{1, 2, 3}, {1, 2, 3}, {0, 1, 0}, {0, 1, 0}, 0.1};
    CHECK(distance(foot_at(path, up_and_down, 0.5), {1, 2.1, 3}) < 1e-15);
    const Swing opposite{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, 0.1};
    CHECK(distance(foot_at(path, opposite, 0.5), {0.5, 0.1, 0}) < 1e-15);
    const Swing along{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0.1};
    CHECK(distance(foot_at(path, along, 0.5), {0.5, 0, 0}) < 1e-15);
}
