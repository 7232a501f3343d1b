#include "up_turn.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

double degrees(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / M_PI; }

}  // namespace

TEST_CASE("a share of the way on a great circle is that share of its angle", "[unit]") {
    const Vec3 a{0, 1, 0};
    for (const double turned : {1e-3, 20.0, 90.0, 150.0, 179.0}) {
        const double angle = turned * M_PI / 180;
        const Vec3 b{std::sin(angle), std::cos(angle), 0};
        for (const double share : {0.1, 0.25, 0.5, 0.7, 0.99}) {
            const Vec3 between = turned_between(a, b, share);
            CHECK(degrees(a, between) == Approx(share * turned).margin(1e-12));
            CHECK(norm(between) == Approx(1).epsilon(1e-15));
        }
        CHECK(turned_between(a, b, 0) == a);
        CHECK(turned_between(a, b, 1) == b);
    }
}

TEST_CASE("a turn takes its steps, along its curve, and ends at the bit", "[unit]") {
    const Vec3 side{1, 0, 0};
    for (const TurnCurve curve : {TurnCurve::linear, TurnCurve::cosine, TurnCurve::slow_in_slow_out}) {
        UpTurn turn;
        for (int i = 1; i <= 30; ++i) {
            turn_up(side, {0, 0, 1}, curve, 30, 90, turn);
            const double s = i / 30.0;
            const double share = curve == TurnCurve::linear   ? s
                                 : curve == TurnCurve::cosine ? (1 - std::cos(M_PI * s)) / 2
                                                              : s * s * (3 - 2 * s);
            CHECK(degrees({0, 1, 0}, turn.up) == Approx(90 * share).margin(1e-11));
        }
        CHECK(turn.up == side);
        turn_up(side, {0, 0, 1}, curve, 30, 90, turn);
        CHECK(turn.up == side);
    }
}

TEST_CASE("no step turns by more than the set rate, whatever is asked when", "[unit]") {
    constexpr double kMost = 4;  // degrees
    for (const TurnCurve curve : {TurnCurve::linear, TurnCurve::cosine, TurnCurve::slow_in_slow_out}) {
        UpTurn turn;
        const Vec3 wanted[] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0.6, 0.8}};
        for (int i = 0; i < 600; ++i) {
            const Vec3 before = turn.up;
            const Vec3 forward = std::abs(before.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
            turn_up(wanted[i / 17 % 6], forward, curve, 5, kMost, turn);
            CHECK(degrees(before, turn.up) <= kMost * (1 + 1e-9));
            CHECK(norm(turn.up) == Approx(1).epsilon(1e-14));
        }
    }
}

TEST_CASE("however low the rate, no step turns by more, and none at all where that is nothing", "[unit]") {
    for (const double most : {1e-5, 1e-7, 1e-12}) {
        UpTurn turn;
        for (int i = 0; i < 1000; ++i) {
            turn_up({1, 0, 0}, {0, 0, 1}, TurnCurve::linear, 12, most, turn);
            CHECK(turn.up.x <= (i + 1) * most * M_PI / 180 * (1 + 1e-6));
        }
        CHECK((turn.up.x > 0) == (most > 1e-9));
    }
}

TEST_CASE("a new polygon before the turn has ended begins another from where the body is", "[unit]") {
    UpTurn turn;
    for (int i = 0; i < 5; ++i) turn_up({1, 0, 0}, {0, 0, 1}, TurnCurve::linear, 10, 90, turn);
    const Vec3 before = turn.up;
    turn_up({0, 0, 1}, {0, 0, 1}, TurnCurve::linear, 10, 90, turn);
    CHECK(turn.from == before);
    CHECK(turn.step == 1);
    for (int i = 0; i < 9; ++i) turn_up({0, 0, 1}, {0, 0, 1}, TurnCurve::linear, 10, 90, turn);
    CHECK(turn.up == Vec3{0, 0, 1});
}

TEST_CASE("from one side of a sheet to the other the body turns over its front", "[unit]") {
    UpTurn turn;
    for (int i = 0; i < 10; ++i) turn_up({0, -1, 0}, {0, 0, 1}, TurnCurve::linear, 20, 90, turn);
    CHECK(distance(turn.up, {0, 0, 1}) < 1e-12);
    for (int i = 0; i < 10; ++i) turn_up({0, -1, 0}, {0, 0, 1}, TurnCurve::linear, 20, 90, turn);
    CHECK(turn.up == Vec3{0, -1, 0});
}

TEST_CASE("angles are told to a thousandth of a degree, and never too small", "[unit]") {
    for (int i = 0; i <= 314; ++i) {
        const double angle = 0.01 * i;
        const Vec3 b{std::sin(angle), std::cos(angle), 0};
        const double told = degrees_between({0, 1, 0}, b), exact = angle * 180 / M_PI;
        CHECK(told >= exact - 1e-9);
        CHECK(told <= exact + 0.001);
    }
    CHECK(degrees_between({0, 1, 0}, {0, -1, 0}) == 180);
}

TEST_CASE("a head turns about the up, the nearer way and no farther than it may", "[unit]") {
    const Vec3 up{0, 1, 0}, ahead{1, 0, 0};
    for (const double degree : {-170.0, -60.0, -3.0, 0.5, 40.0, 120.0}) {
        const double angle = degree * M_PI / 180;
        const Vec3 to{std::cos(angle), 0, std::sin(angle)};
        const Vec3 turned = turned_about(up, ahead, to, 5);
        CHECK(degrees(ahead, turned) == Approx(std::min(5.0, std::abs(degree))).margin(1e-9));
        CHECK(dot(cross(ahead, to), cross(ahead, turned)) >= 0);
        CHECK(std::abs(dot(turned, up)) < 1e-15);
    }
    CHECK(turned_about(up, ahead, {0.6, 0, 0.8}, 60) == Vec3{0.6, 0, 0.8});
    CHECK(degrees(ahead, turned_about(up, ahead, {-1, 0, 0}, 5)) == Approx(5));
}

TEST_CASE("a forward that is carried over an edge keeps its angle to it", "[unit]") {
    const Vec3 before{0, 1, 0}, after{1, 0, 0};  // about z
    const Vec3 forward{0.6, 0, 0.8};
    CHECK(distance(carried_over(forward, before, after), {0, -0.6, 0.8}) < 1e-15);
    CHECK(carried_over({0, 0, 1}, before, after) == Vec3{0, 0, 1});
    CHECK(distance(carried_over(forward, before, before), forward) < 1e-15);
}
