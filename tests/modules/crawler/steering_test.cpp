#include "steering.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
const Vec3 kUp{0, 1, 0};

/// The turn towards an aim that lies so many degrees to the left of what looks along x.
double turn_at(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return turn_towards({}, {1, 0, 0}, kUp, {std::cos(angle), 0, -std::sin(angle)});
}

}  // namespace

TEST_CASE("a script holds from its begin until before its end, and of two the later one", "[unit]") {
    const TimedCommand script[] = {{0.5, 1.5, {1, 0.25}}, {1, 1.25, {-1, 0}}, {3, kForever, {0, -1}}};
    CHECK_FALSE(command_at(script, 0.4999));
    CHECK(command_at(script, 0.5)->turn == 0.25);
    CHECK(command_at(script, 0.5 - 1e-12)->turn == 0.25);  // frames' times are rounded
    CHECK(command_at(script, 1)->pace == -1);
    CHECK(command_at(script, 1.25)->pace == 1);
    CHECK_FALSE(command_at(script, 1.5));
    CHECK_FALSE(command_at(script, 1.5 - 1e-12));
    CHECK(command_at(script, 1e9)->turn == -1);
    CHECK_FALSE(command_at({}, 0));
}

TEST_CASE("an aim to the left turns left, to the right right, and as far as it can from 30 degrees on",
          "[unit]") {
    CHECK(turn_at(0) == 0);
    CHECK(turn_at(10) == Approx(2 * std::sin(std::numbers::pi / 18)));
    CHECK(turn_at(-10) == -turn_at(10));
    CHECK(turn_at(29) < 1);
    for (const double degrees : {31., 60., 90., 120., 179.}) {
        CHECK(turn_at(degrees) == 1);
        CHECK(turn_at(-degrees) == -1);
    }
    CHECK(std::abs(turn_at(180)) == 1);  // it does not go on away from what is right behind
}

TEST_CASE("whether an aim is far or near, above or below changes no turn, and one right above asks for none",
          "[unit]") {
    const double expected = turn_at(20);
    for (const double far : {1e-6, 0.1, 1e6})
        for (const double high : {-2., 0., 5.}) {
            const Vec3 from{0.3, 0.2, -0.1};
            const double angle = std::numbers::pi / 9;
            const Vec3 aim = from + far * Vec3{std::cos(angle), high, -std::sin(angle)};
            CHECK(turn_towards(from, {1, 0, 0}, kUp, aim) == Approx(expected).epsilon(1e-6));
        }
    CHECK(turn_towards({}, {1, 0, 0}, kUp, {0, 3, 0}) == 0);
    CHECK(turn_towards({}, {1, 0, 0}, kUp, {}) == 0);
    // On a ceiling, left is the other way.
    CHECK(turn_towards({}, {1, 0, 0}, -kUp, {1, 0, -1}) == -1);
}

TEST_CASE("along a straight line the aim lies so far on from the nearest point, and stops at its end",
          "[unit]") {
    const Path path{{{0, 0, 0}, {1, 0, 0}, {1, 0, 2}}, false, 0.25};
    CHECK(distance(aim_along(path, {0.5, 0.3, -0.2}), {0.75, 0, 0}) < 1e-12);
    CHECK(distance(aim_along(path, {0.9, 0, -0.2}), {1, 0, 0.15}) < 1e-12);  // round the corner
    CHECK(distance(aim_along(path, {-3, 0, 0}), {0.25, 0, 0}) < 1e-12);
    CHECK(distance(aim_along(path, {1, 0, 1.9}), {1, 0, 2}) < 1e-12);
    CHECK(distance(aim_along(path, {1, 0, 9}), {1, 0, 2}) < 1e-12);
}

TEST_CASE("a loop goes on from its last point to its first, any number of times round", "[unit]") {
    Path square{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, true, 0.5};
    CHECK(distance(aim_along(square, {-0.1, 0, 0.25}), {0.25, 0, 0}) < 1e-12);
    CHECK(distance(aim_along(square, {-0.1, 0, 0.75}), {0, 0, 0.25}) < 1e-12);
    square.ahead = 4.25;
    CHECK(distance(aim_along(square, {0.5, 0, 0}), {0.75, 0, 0}) < 1e-12);
}

TEST_CASE("a path of points that meet, or of one, still has an aim on it", "[unit]") {
    for (const bool loop : {false, true}) {
        CAPTURE(loop);
        CHECK(aim_along({{{1, 2, 3}}, loop, 0.5}, {9, 9, 9}) == Vec3{1, 2, 3});
        CHECK(aim_along({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, loop, 0.5}, {9, 9, 9}) == Vec3{1, 2, 3});
        const Path doubled{{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}, loop, 0.25};
        CHECK(distance(aim_along(doubled, {0.4, 1, 0}), {0.65, 0, 0}) < 1e-12);
    }
}

TEST_CASE("an aim is on the path, from wherever it is asked, and no farther along than asked", "[unit]") {
    const RandomStream random(3, "paths");
    for (std::uint64_t i = 0; i < 200; ++i) {
        Path path{{}, i % 2 == 0, random.uniform(100 * i, 0.01, 5)};
        for (std::uint64_t k = 0; k < 2 + i % 5; ++k)
            path.points.push_back({random.uniform(100 * i + 3 * k + 1, -1, 1),
                                   random.uniform(100 * i + 3 * k + 2, -1, 1),
                                   random.uniform(100 * i + 3 * k + 3, -1, 1)});
        const Vec3 aim = aim_along(path, {random.uniform(100 * i + 90, -2, 2), 0, 0});
        double off = kForever;
        for (std::size_t k = 0; k + (path.loop ? 0 : 1) < path.points.size(); ++k) {
            const Vec3 from = path.points[k], way = path.points[(k + 1) % path.points.size()] - from;
            const double share = std::clamp(dot(aim - from, way) / dot(way, way), 0.0, 1.0);
            off = std::min(off, distance(aim, from + share * way));
        }
        CHECK(off < 1e-12);
    }
}
