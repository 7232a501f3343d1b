#include "aim.hpp"

#include <cmath>
#include <limits>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

/// How far `target` is from the plane of the bones, and on which side of the root it is there.
struct InPlane {
    double away, along;
};

InPlane in_plane(const Leg& leg, const LegPose& pose, const Vec3& target) {
    const Frame frame = foot_frame(leg, {pose[kYaw], pose[kTilt]});  // straight: the plane's own
    return {std::abs(dot(frame.z, target)), dot(frame.x, target)};
}

}  // namespace

TEST_CASE("a plane faces a target that its yaw can reach at the tilt that there is", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    for (const double tilt : {-0.4, 0.0, 0.3, 0.9})
        for (const double heading : {-0.5, 0.0, 0.5})
            for (const double up : {-0.4, 0.0, 0.2}) {
                LegPose pose = rest_pose(leg);
                pose[kTilt] = tilt;
                const Vec3 target{std::cos(heading), up, std::sin(heading)};
                face(leg, target, 1, pose);
                CHECK(pose[kTilt] == tilt);
                CHECK(violation(leg, pose) == 0);
                const InPlane seen = in_plane(leg, pose, target);
                CHECK(seen.away < 1e-14);
                CHECK(seen.along > 0);
            }
}

TEST_CASE("where yaw does not do, the plane tilts as far as it may", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    LegPose pose = rest_pose(leg);
    const Vec3 target{0.2, -0.6, 0.45};  // 66 degrees aside, where yaw ends at 60
    face(leg, target, 1, pose);
    CHECK(pose[kYaw] == leg.min[kYaw]);
    CHECK(violation(leg, pose) == 0);
    CHECK(in_plane(leg, pose, target).away < 1e-14);
    pose = rest_pose(leg);
    face(leg, {-0.1, 0.01, 0.8}, 1, pose);  // out of the reach of both
    CHECK(pose[kYaw] == leg.min[kYaw]);
    CHECK(violation(leg, pose) == 0);
    pose = rest_pose(leg);
    face(leg, target, 1, pose, false);
    CHECK(pose[kYaw] < leg.min[kYaw]);
    CHECK(in_plane(leg, pose, target).away < 1e-14);
}

TEST_CASE("a curled leg faces what is behind its root with the foot that is there", "[unit]") {
    const Leg leg = creature("ant").limbs[0].leg;
    LegPose pose = rest_pose(leg);
    pose[kPitch] = leg.min[kPitch];
    for (std::size_t j = kPitch + 1; j < kJoints; ++j) pose[j] = leg.min[j];
    const Vec3 target{-0.3, -0.2, 0.1};
    CHECK(foot_side(leg, pose) == -1);
    face(leg, target, foot_side(leg, pose), pose);
    const InPlane seen = in_plane(leg, pose, target);
    CHECK(seen.away < 1e-14);
    CHECK(seen.along < 0);
}

TEST_CASE("starts are legal, and no two of a round are the same", "[unit]") {
    for (const std::string& name : kCreatures) {
        const Leg leg = creature(name).limbs[0].leg;
        for (int a = 0; a < 8; ++a) {
            const LegPose start = start_pose(leg, {0.3, -0.2, 0.1}, a);
            CHECK(violation(leg, start) == 0);
            CHECK(start == start_pose(leg, {0.3, -0.2, 0.1}, a + 8));
            for (int b = 0; b < a; ++b) CHECK(start != start_pose(leg, {0.3, -0.2, 0.1}, b));
        }
    }
}

TEST_CASE("what is aimed at is no further away than the leg is long, however far the target", "[unit]") {
    const Leg leg = creature("lizard").limbs[0].leg;
    const auto aim = [&](double x, double y, double z) { return aim_at(leg, Triple<double>{x, y, z}); };
    const Aim<double> near = aim(0.3 * leg.length, -0.2 * leg.length, 0);
    CHECK((near.finite && !near.beyond));
    CHECK(near.at.x == Approx(0.3).epsilon(1e-15));
    CHECK(near.at.y == Approx(-0.2).epsilon(1e-15));
    const Aim<double> root = aim(0, 0, 0);
    CHECK((root.finite && !root.beyond && root.at.x == 0));
    for (const double far : {1.5 * leg.length, 1.0, 1e200, std::numeric_limits<double>::max()}) {
        const Aim<double> beyond = aim(far, -far, far);
        CHECK((beyond.finite && beyond.beyond));
        CHECK(beyond.at.x == Approx(std::sqrt(1.0 / 3)).epsilon(1e-15));
        CHECK(beyond.at.y == -beyond.at.x);
    }
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {inf, -inf, std::nan("")}) {
        CHECK_FALSE(aim(bad, 0, 0).finite);
        CHECK_FALSE(aim(0, bad, 1e308).finite);
        CHECK_FALSE(aim(0, 0, bad).finite);
    }
}
