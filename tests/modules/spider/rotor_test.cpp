#include "rotor.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace orbweaver::spider;

TEST_CASE("a rotor is the angle's cosine and sine, from half a turn back to half a turn on", "[unit]") {
    double worst = 0;
    for (int i = -100000; i <= 100000; ++i) {
        const double angle = std::numbers::pi * i / 100000;
        const Rotor<double> turn = rotor(angle);
        worst = std::max({worst, std::abs(turn.c - std::cos(angle)), std::abs(turn.s - std::sin(angle))});
    }
    CHECK(worst < 2e-15);  // a unit of the last place near 1 and its rounding, doubled twice
    CHECK(rotor(0.0).c == 1);
    CHECK(rotor(0.0).s == 0);
}

TEST_CASE("four lanes of rotors give the bits of one", "[unit]") {
    for (int i = -1000; i <= 1000; ++i) {
        const double angle = 0.0031 * i;
        const Rotor<Lanes4> lanes = rotor(Lanes4{angle, -angle, 0.5 * angle, 0.25});
        const double angles[] = {angle, -angle, 0.5 * angle, 0.25};
        for (int k = 0; k < 4; ++k) {
            CHECK(lanes.c[k] == rotor(angles[k]).c);
            CHECK(lanes.s[k] == rotor(angles[k]).s);
        }
    }
}

TEST_CASE("the angle of a direction is atan2's", "[unit]") {
    double worst = 0;
    for (int i = -100000; i <= 100000; ++i) {
        const double angle = std::numbers::pi * i / 100000;
        const double c = 3e-5 * std::cos(angle), s = 3e-5 * std::sin(angle);
        worst = std::max(worst, std::abs(angle_of(c, s) - std::atan2(s, c)));
    }
    CHECK(worst < 1e-15);
    CHECK(angle_of(0, 0) == 0);
    CHECK(angle_of(1, 0) == 0);
    CHECK(angle_of(-1, 0) == Approx(std::numbers::pi).epsilon(1e-15));
}
