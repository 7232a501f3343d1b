#include "fabrik.hpp"

#include <cmath>

#include "creatures.hpp"
#include "leg_solver.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

TEST_CASE("reaching back and out keeps bones as long as they are, and both ends in their places", "[unit]") {
    const RandomStream random(9, "chains");
    std::uint64_t count = 0;
    const auto draw = [&] {
        const double x = random.uniform(count++, -1, 1), y = random.uniform(count++, -1, 1);
        return Vec3{x, y, random.uniform(count++, -1, 1)};
    };
    for (int round = 0; round < 1000; ++round) {
        std::array<Vec3, 5> joints;
        std::array<double, 4> lengths{};
        for (Vec3& joint : joints) joint = draw();
        for (double& length : lengths) length = random.uniform(count++, 0.1, 1);
        const Vec3 root = joints[0], target = draw();
        const auto check_lengths = [&] {
            for (std::size_t i = 0; i < 4; ++i)
                CHECK(std::abs(distance(joints[i], joints[i + 1]) - lengths[i]) < 1e-15);
        };
        reach_back(joints, lengths, target);
        CHECK(joints[4] == target);
        check_lengths();
        reach_out(joints, lengths, root);
        CHECK(joints[0] == root);
        check_lengths();
    }
}

TEST_CASE("points on top of each other are drawn apart", "[unit]") {
    std::array<Vec3, 3> joints{};
    const std::array<double, 2> lengths{1, 2};
    reach_out(joints, lengths, {});
    CHECK(joints[1] == Vec3{1, 0, 0});
    CHECK(distance(joints[2], joints[1]) == 2);
}

TEST_CASE("without limits FABRIK reaches what is within reach, warm", "[unit]") {
    for (const Limb& limb : creature("huntsman").limbs) {
        ReachableWalk walk(limb.leg, 0.02 * limb.leg.length);
        LegPose pose = rest_pose(limb.leg);
        int missed = 0;
        for (int step = 0; step < 2000; ++step) {
            const LegTarget target = walk.next();
            find_leg_solver("fabrik_unlimited")->solve(limb.leg, target, {}, pose);
            missed += distance(foot_position(limb.leg, pose), target.position) > 1e-4 * limb.leg.length;
        }
        INFO(limb.name);
        CHECK(missed == 0);
    }
}

TEST_CASE("with limits FABRIK keeps them, and follows a foot about its home", "[unit]") {
    for (const Limb& limb : creature("huntsman").limbs) {
        const Vec3 home = foot_position(limb.leg, rest_pose(limb.leg));
        const double radius = 0.15 * limb.leg.length;
        LegPose pose = rest_pose(limb.leg);
        double worst = 0, past = 0;
        for (int step = 0; step < 1000; ++step) {
            const Vec3 target = home + radius * Vec3{0, 0.3 * std::sin(0.05 * step), std::cos(0.05 * step)};
            find_leg_solver("fabrik")->solve(limb.leg, {target}, {}, pose);
            worst = std::max(worst, distance(foot_position(limb.leg, pose), target) / limb.leg.length);
            past = std::max(past, violation(limb.leg, pose));
        }
        INFO(limb.name);
        CHECK(worst <= 1.001e-6);
        CHECK(past == 0);
    }
}
