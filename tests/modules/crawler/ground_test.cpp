#include "ground.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

constexpr Cliff kCliff{0.3, -0.2, 0.05, 0.25};
constexpr double kSpacing = 1e-4;  // m, of places on the profile

/// Places on the profile within a metre: the upper floor, the quarter of a circle, the wall, the lower floor.
std::vector<Vec3> profile(const Cliff& cliff) {
    std::vector<Vec3> places;
    const double low = cliff.height - cliff.drop;
    for (double x = cliff.edge - 1; x < cliff.edge - cliff.radius; x += kSpacing)
        places.push_back({x, cliff.height, 0});
    for (double angle = 0; angle < M_PI / 2; angle += kSpacing / std::max(cliff.radius, kSpacing))
        places.push_back({cliff.edge - cliff.radius + cliff.radius * std::sin(angle),
                          cliff.height - cliff.radius + cliff.radius * std::cos(angle), 0});
    for (double y = cliff.height - cliff.radius; y > low; y -= kSpacing) places.push_back({cliff.edge, y, 0});
    for (double x = cliff.edge; x < cliff.edge + 1; x += kSpacing) places.push_back({x, low, 0});
    return places;
}

bool is_inside(const Cliff& cliff, const Vec3& p) {
    if (p.y < cliff.height - cliff.drop) return true;
    const double back = cliff.edge - p.x, down = cliff.height - p.y;
    if (back < 0 || down < 0) return false;
    if (back > cliff.radius || down > cliff.radius) return true;
    return std::hypot(cliff.radius - back, cliff.radius - down) < cliff.radius;
}

/// Whether both the upper ground and the lower one have it below them.
bool is_in_both(const Cliff& cliff, const Vec3& p) {
    return p.y < cliff.height - cliff.drop && p.x < cliff.edge;
}

template <class Check>
void for_places(const Cliff& cliff, int count, const Check& check) {
    const RandomStream random(3, "places");
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<std::uint64_t>(3 * i);
        check(Vec3{cliff.edge + random.uniform(n, -0.3, 0.3),
                   cliff.height + random.uniform(n + 1, -cliff.drop - 0.1, 0.1), random.uniform(n + 2, -1, 1)});
    }
}

}  // namespace

TEST_CASE("a floor is as deep above a point as that is below it, straight up", "[unit]") {
    const Floor floor{0.4};
    for (const double y : {-3.0, 0.39, 0.4, 0.41, 7.0}) {
        const Touch touch = floor.touch({5, y, -9}, 7);
        CHECK(touch.depth == 0.4 - y);
        CHECK(touch.normal == Vec3{0, 1, 0});
        CHECK(touch.grip == 1);
    }
}

TEST_CASE("a cliff is as far as the nearest place on its profile, and its normal leads there", "[unit]") {
    for (const double radius : {0.0, 0.01, 0.05, 0.125}) {
        Cliff cliff = kCliff;
        cliff.radius = radius;
        const auto places = profile(cliff);
        int inside = 0, rounded = 0;
        for_places(cliff, 600, [&](const Vec3& p) {
            if (is_in_both(cliff, p)) return;
            const Vec3 level{p.x, p.y, 0};
            double nearest = 1;
            for (const Vec3& each : places) nearest = std::min(nearest, distance(level, each));
            const Touch touch = cliff.touch(p, 0);
            // The nearest of places so far apart is at most that far beside the nearest point.
            CHECK(std::abs(touch.depth) <= nearest + 1e-12);
            CHECK(std::abs(touch.depth) >= nearest - kSpacing);
            CHECK((touch.depth > 0) == is_inside(cliff, p));
            CHECK(norm(touch.normal) == Approx(1).epsilon(1e-12));
            CHECK(touch.normal.z == 0);
            CHECK(touch.grip == 1);
            const Touch there = cliff.touch(p + touch.depth * touch.normal, 0);
            CHECK(std::abs(there.depth) < 1e-12);
            if (touch.depth > 0) ++inside;
            if (touch.normal.x > 0.01 && touch.normal.y > 0.01) ++rounded;
        });
        CHECK(inside > 100);
        CHECK(rounded > 10);
    }
}

TEST_CASE("what is deep under both floors of a cliff is brought out by being put up where it is told",
          "[unit]") {
    int many = 0;
    for_places(kCliff, 2000, [&](Vec3 p) {
        if (!is_in_both(kCliff, p)) return;
        ++many;
        for (int i = 0; i < 2; ++i) {
            const Touch touch = kCliff.touch(p, 0);
            if (i == 0) CHECK(touch.depth > 0);
            if (touch.depth > 0) p += touch.depth * touch.normal;
        }
        CHECK(kCliff.touch(p, 0).depth < 1e-12);
    });
    CHECK(many > 100);
}

TEST_CASE("the way over a cliff's edge has no corner", "[unit]") {
    // The normal turns from up to out evenly along the rounding, and is what it is on the floor and the wall.
    const Vec3 axis{kCliff.edge - kCliff.radius, kCliff.height - kCliff.radius, 2};
    for (int degrees = -20; degrees <= 110; ++degrees) {
        const double angle = M_PI / 180 * std::clamp(degrees, 0, 90);
        Vec3 p = axis + kCliff.radius * Vec3{std::sin(angle), std::cos(angle), 0};
        if (degrees < 0) p.x += 1e-3 * degrees;
        if (degrees > 90) p.y -= 1e-3 * (degrees - 90);
        for (const double off : {-1e-6, 0.0, 1e-6}) {
            const Vec3 normal{std::sin(angle), std::cos(angle), 0};
            const Touch touch = kCliff.touch(p + off * normal, 0);
            CHECK(touch.depth == Approx(-off).margin(1e-15));
            CHECK(distance(touch.normal, normal) < 1e-12);
        }
    }
}
