#include "comfort.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver::spider;

namespace {

Leg sample_leg(double stiffness) {
    std::array<JointRange, kJoints> joints;
    joints.fill({-2, 3, -1, 1, stiffness, 0.5});
    joints[kTilt] = {-1, 1, -1, 1, stiffness, 0};  // comfortable up to the limit
    joints[kPitch] = {};                           // does not turn
    return make_leg({1, 1, 1, 1, 1, 1}, joints);
}

}  // namespace

TEST_CASE("a joint turns freely within comfort and back towards it", "[unit]") {
    const Leg leg = sample_leg(0.5);
    for (const double angle : {-1.0, -0.3, 0.5, 1.0})
        for (const double wish : {-1.0, 1e-9, 1.0}) CHECK(compliance(leg, kYaw, angle, wish) == 1);
    CHECK(compliance(leg, kYaw, 2.9, -1.0) == 1);
    CHECK(compliance(leg, kYaw, 3.0, -1.0) == 1);
    CHECK(compliance(leg, kYaw, -2.0, 1.0) == 1);
}

TEST_CASE("resistance grows from comfort to the limit, where nothing moves outward", "[unit]") {
    for (const double stiffness : {0.0, 0.5, 1.0}) {
        const Leg leg = sample_leg(stiffness);
        CHECK(compliance(leg, kYaw, 2.0, 1.0) == Approx(0.5 * (1 - 0.5 * stiffness)));  // halfway
        CHECK(compliance(leg, kYaw, -1.5, -1.0) == Approx(0.5 * (1 - 0.5 * stiffness)));
        double before = 1;
        for (const double angle : {1.001, 1.3, 1.7, 2.1, 2.5, 2.9, 2.999}) {
            const double now = compliance(leg, kYaw, angle, 1.0);
            CHECK(now < before);
            before = now;
        }
        CHECK(compliance(leg, kYaw, 3.0, 1.0) == 0);
        CHECK(compliance(leg, kYaw, -2.0, -1.0) == 0);
        CHECK(compliance(leg, kTilt, 0.999, 1.0) == 1);
        CHECK(compliance(leg, kTilt, 1.0, 1.0) == 0);
        CHECK(compliance(leg, kPitch, 0.0, 1.0) == 0);
        CHECK(compliance(leg, kPitch, 0.0, -1.0) == 0);
    }
}

TEST_CASE("a joint wishes itself back into comfort, and a little to its rest", "[unit]") {
    const Leg leg = sample_leg(0.5);
    CHECK(comfort_wish(leg, kYaw, 0.9, 0.25, 0.0) == 0);
    CHECK(comfort_wish(leg, kYaw, 2.0, 0.25, 0.0) == Approx(-0.25));
    CHECK(comfort_wish(leg, kYaw, -1.4, 0.25, 0.0) == Approx(0.1));
    CHECK(comfort_wish(leg, kYaw, 0.9, 0.25, 0.1) == Approx(-0.04));
}
