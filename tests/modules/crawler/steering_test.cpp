#include "steering.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

const Vec3 kUp{0, 1, 0};

/// The turn towards an aim that lies so many degrees to the left of what looks along x.
double turn_at(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return turn_towards({}, {1, 0, 0}, kUp, {std::cos(angle), 0, -std::sin(angle)});
}

}  // namespace

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
