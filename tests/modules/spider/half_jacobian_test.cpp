#include <cmath>
#include <limits>

#include "creatures.hpp"
#include "leg_solver.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

LegResult solve(const Leg& leg, const Vec3& position, LegPose& pose, const LegSolverOptions& options = {}) {
    return find_leg_solver("half_jacobian")->solve(leg, {position}, options, pose);
}

double error(const Leg& leg, const LegPose& pose, const Vec3& position) {
    return distance(foot_position(leg, pose), position) / leg.length;
}

}  // namespace

TEST_CASE("warm, every reachable target is reached, and no joint passes its limit", "[unit]") {
    for (const std::string& name : kCreatures)
        for (const Limb& limb : creature(name).limbs)
            for (const double stride : {0.002, 0.02, 0.1}) {
                ReachableWalk walk(limb.leg, stride * limb.leg.length);
                LegPose pose = rest_pose(limb.leg);
                int missed = 0;
                double worst = 0, past = 0;
                for (int step = 0; step < 2000; ++step) {
                    const Vec3 target = walk.next().position;
                    const LegResult result = solve(limb.leg, target, pose);
                    missed += result.answer != LegAnswer::reached;
                    worst = std::max(worst, error(limb.leg, pose, target));
                    past = std::max(past, violation(limb.leg, pose));
                }
                INFO(name << " " << limb.name << ", stride " << stride);
                CHECK(missed == 0);
                CHECK(worst <= 1.0001e-6);  // the tolerance, and rounding
                CHECK(past == 0);
            }
}

TEST_CASE("cold, 99.9 % of reachable targets are reached", "[unit]") {
    for (const std::string& name : kCreatures) {
        const Species species = creature(name);
        for (std::size_t i = 0; i < species.limbs.size(); i += 2) {
            const Leg& leg = species.limbs[i].leg;
            LegalPoses poses(leg);
            int missed = 0;
            for (int round = 0; round < 10000; ++round) {
                const Vec3 target = foot_position(leg, poses.next());
                LegPose pose = rest_pose(leg);
                const LegResult result = solve(leg, target, pose);
                const double left = error(leg, pose, target);
                if (result.answer == LegAnswer::reached)
                    REQUIRE(left <= result.error / leg.length + 1e-14);  // a bound
                else
                    REQUIRE(left == Approx(result.error / leg.length).margin(1e-14));
                missed += left > 1e-4;
            }
            INFO(name << " " << species.limbs[i].name);
            CHECK(missed <= 10);
        }
    }
}

TEST_CASE("wherever targets are, limits hold and answers are true", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    const RandomStream random(5, "targets");
    LegPose pose = rest_pose(leg);
    int answers[4] = {};
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const auto draw = [&](std::uint64_t k) { return leg.length * random.uniform(3 * i + k, -1.2, 1.2); };
        const Vec3 target{draw(0), draw(1), draw(2)};
        LegSolverOptions few;
        few.restarts = 1;
        const LegResult result = solve(leg, target, pose, few);
        ++answers[static_cast<int>(result.answer)];
        REQUIRE(violation(leg, pose) == 0);
        REQUIRE((result.answer == LegAnswer::out_of_reach) == (norm(target) > leg.length));
        if (result.answer == LegAnswer::reached) REQUIRE(error(leg, pose, target) <= 1.0001e-6);
        if (result.answer == LegAnswer::blocked) REQUIRE(error(leg, pose, target) > 1e-6);
    }
    for (const LegAnswer each : {LegAnswer::reached, LegAnswer::out_of_reach, LegAnswer::blocked})
        CHECK(answers[static_cast<int>(each)] > 5000);
    CHECK(answers[static_cast<int>(LegAnswer::refused)] == 0);
}

TEST_CASE("out of reach, the leg stretches towards the target and says so", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    for (const double far : {1.001, 2.0, 1e3, 1e150, 1e300, 1.7e308}) {
        const Vec3 direction = Vec3{1, 0.3, -0.4} / norm({1, 0.3, -0.4});
        LegPose pose = rest_pose(leg);
        const double distance_to = far > 1e9 ? far : far * leg.length;
        const LegResult result = solve(leg, distance_to * direction, pose);
        CHECK(result.answer == LegAnswer::out_of_reach);
        // Straight joints are within this leg's limits, so it gets all the way there.
        CHECK(distance(foot_position(leg, pose), leg.length * direction) < 1e-3 * leg.length);
        CHECK(result.steps <= LegSolverOptions{}.max_steps);
    }
}

TEST_CASE("a target at the root is reached by a leg that curls up, and blocked for one that does not",
          "[unit]") {
    for (const Limb& limb : creature("huntsman").limbs) {
        LegPose pose = rest_pose(limb.leg);
        CHECK(solve(limb.leg, {}, pose).answer == LegAnswer::reached);
        CHECK(violation(limb.leg, pose) == 0);
        CHECK(norm(foot_position(limb.leg, pose)) <= 1.0001e-6 * limb.leg.length);
    }
    std::array<JointRange, kJoints> stiff;
    stiff.fill({-0.2, 0.2, -0.1, 0.1, 0.5, 0});
    const Leg leg = make_leg({1, 1, 1, 1, 1, 1}, stiff);
    LegPose pose = rest_pose(leg);
    const LegResult result = solve(leg, {}, pose);
    CHECK(result.answer == LegAnswer::blocked);
    CHECK(violation(leg, pose) == 0);
    LegPose bent{};
    for (std::size_t j = kPitch + 1; j < kJoints; ++j) bent[j] = leg.max[j];
    CHECK(result.error == Approx(norm(foot_position(leg, bent))).epsilon(1e-3));  // the nearest there is
}

TEST_CASE("a straight leg whose target is in line with it bends", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    for (const double share : {0.999, 0.9, 0.7, 0.5}) {
        LegPose pose{};
        const LegResult result = solve(leg, {share * leg.length, 0, 0}, pose);
        CHECK(result.answer == LegAnswer::reached);
        CHECK(error(leg, pose, {share * leg.length, 0, 0}) <= 1.0001e-6);
    }
}

TEST_CASE("a target that is not finite is refused, and the pose kept", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vec3& target : {Vec3{nan, 0, 0}, Vec3{0, inf, 0}, Vec3{0, 0, -inf}, Vec3{nan, inf, nan}}) {
        LegPose pose = rest_pose(leg);
        const LegResult result = solve(leg, target, pose);
        CHECK(result.answer == LegAnswer::refused);
        CHECK(result.steps == 0);
        CHECK(pose == rest_pose(leg));
    }
}

TEST_CASE("a foot that stays lets its leg relax into comfort", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    const auto discomfort = [&](const LegPose& pose) {
        double sum = 0;
        for (std::size_t j = 0; j < kJoints; ++j)
            sum += std::max({0.0, leg.comfort_min[j] - pose[j], pose[j] - leg.comfort_max[j]});
        return sum;
    };
    LegPose pose = rest_pose(leg);
    const Vec3 target = foot_position(leg, pose);
    pose[kTilt] = leg.max[kTilt];
    pose[4] = leg.min[4];
    pose[6] = leg.max[6];
    const double before = discomfort(pose);
    REQUIRE(before > 0.8);
    for (int call = 0; call < 60; ++call) REQUIRE(solve(leg, target, pose).answer == LegAnswer::reached);
    CHECK(discomfort(pose) < 0.01);
    for (int call = 0; call < 600; ++call) solve(leg, target, pose);
    for (std::size_t j = 0; j < kJoints; ++j) CHECK(pose[j] == Approx(leg.rest[j]).margin(0.02));
}
