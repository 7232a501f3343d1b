#include "orbweaver/polyline.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "orbweaver/random.hpp"

using namespace orbweaver;

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

struct Path {
    std::vector<Vec3> points;
    bool loop = false;
    double ahead = 0;
};
Vec3 aim_along(const Path& path, const Vec3& position) {
    return ahead_on(path.points, path.loop, position, path.ahead).point;
}

}  // namespace

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

TEST_CASE("a line tells whether it ended before it got so far, which a loop never does", "[unit]") {
    const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
    CHECK_FALSE(ahead_on(corner, false, {0, 0, 0}, 1.99).is_end);
    CHECK(ahead_on(corner, false, {0, 0, 0}, 2.01).is_end);
    CHECK_FALSE(ahead_on(corner, true, {0, 0, 0}, 100).is_end);
    CHECK(ahead_on({{{1, 2, 3}}}, true, {0, 0, 0}, 1).is_end);
}
