#include "camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr Camera kAhead{
    {0, 0, 2}, {0, 0, 0}, 90};  // looks along -z; half a picture's height at unit depth is 1

void check_near(const Vec3& a, const Vec3& b) { CHECK(distance(a, b) < 1e-12); }

}  // namespace

TEST_CASE("a point lands where the pinhole equation says", "[unit]") {
    const auto target = project(kAhead, {0, 0, 0}, 640, 480);
    CHECK(target.x == Approx(320));
    CHECK(target.y == Approx(240));
    CHECK(target.depth == Approx(2));
    // f = 480 / 2 px, so one metre at two metres' depth is 120 px.
    const auto aside = project(kAhead, {1, 1, 0}, 640, 480);
    CHECK(aside.x == Approx(440));
    CHECK(aside.y == Approx(120));
    CHECK(project(kAhead, {0, 0, 3}, 640, 480).depth < 0);
}

TEST_CASE("the matrix agrees with the pinhole equation", "[unit]") {
    const Camera camera{{0.3, 0.7, 1.9}, {-0.2, 0.1, 0.4}, 37};
    const auto m = view_projection(camera, 1.5, 0.01, 100);
    for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{0.4, -0.3, 0.2}, Vec3{-1, 1, -3}}) {
        const auto row = [&](std::size_t r) {
            return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r];
        };
        const auto landing = project(camera, p, 600, 400);
        CHECK(row(3) == Approx(landing.depth));
        CHECK((row(0) / row(3) + 1) * 300 == Approx(landing.x));
        CHECK((1 - row(1) / row(3)) * 200 == Approx(landing.y));
    }
    // Near and far planes at the ends of clip space.
    const auto a = axes(camera);
    for (const auto& [depth, expected] : {std::pair{0.01, -1.0}, std::pair{100.0, 1.0}}) {
        const Vec3 p = camera.position + a.forward * depth;
        const double z = m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14];
        CHECK(z / depth == Approx(expected).margin(1e-3));
    }
}

TEST_CASE("the camera stands upright, also when it looks straight down", "[unit]") {
    const auto level = axes(kAhead);
    check_near(level.right, {1, 0, 0});
    check_near(level.up, {0, 1, 0});
    const auto down = axes({{0, 3, 0}, {0, 0, 0}, 40});
    check_near(down.right, {1, 0, 0});
    check_near(down.up, {0, 0, -1});
}

TEST_CASE("an orbit keeps its distance and stops short of the pole", "[unit]") {
    const auto half_turn = orbit(kAhead, 1, 0);
    check_near(half_turn.position, {0, 0, -2});
    const auto quarter = orbit(kAhead, 0.5, 0);
    check_near(quarter.position, {-2, 0, 0});  // dragging right brings the left side into view
    const auto over = orbit(kAhead, 0, -5);
    CHECK(norm(over.position) == Approx(2));
    CHECK(over.position.y < 2);
    CHECK(over.position.y > 1.9);
}

TEST_CASE("a notch of the wheel is a tenth of the distance", "[unit]") {
    CHECK(zoom(kAhead, 1).position.z == Approx(1.8));
    CHECK(zoom(zoom(kAhead, 3), -3).position.z == Approx(2));
}

TEST_CASE("framing puts every point into the picture and fills most of it", "[unit]") {
    const std::vector<Vec3> points = {{-0.3, 0.1, 0}, {0.25, 0.2, 0.1}, {0.1, -0.4, -0.05}};
    const Vec3 target = middle(points);
    check_near(target, {-0.025, -0.1, 0.025});
    const auto camera = frame_points(points, target, 40, 16.0 / 9);
    double nearest_edge = 1e9;
    for (const Vec3& p : points) {
        const auto l = project(camera, p, 1280, 720);
        nearest_edge = std::min({nearest_edge, l.x, l.y, 1280 - l.x, 720 - l.y});
    }
    CHECK(nearest_edge > 0);
    CHECK(nearest_edge < 0.06 * 720);
    check_near(frame_points({}, {1, 2, 3}, 40, 1).position, {1, 2, 4});
}
