#include <cmath>

#include "creatures.hpp"
#include "leg_solver.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

LegResult solve(const Leg& leg, const LegTarget& target, LegPose& pose) {
    return find_leg_solver("full_jacobian")->solve(leg, target, {}, pose);
}

/// Of place, leg lengths, or of the axes of the last bone: the largest.
double error(const Leg& leg, const LegPose& pose, const LegTarget& target) {
    const Frame frame = foot_frame(leg, pose);
    return std::max({distance(foot_position(leg, pose), target.position) / leg.length,
                     distance(frame.x, target.orientation.x), distance(frame.y, target.orientation.y),
                     distance(frame.z, target.orientation.z)});
}

}  // namespace

TEST_CASE("warm, the full Jacobian brings foot and last bone where they should be", "[unit]") {
    for (const Limb& limb : creature("huntsman").limbs) {
        ReachableWalk walk(limb.leg, 0.02 * limb.leg.length);
        LegPose pose = rest_pose(limb.leg);
        double worst = 0, past = 0;
        for (int step = 0; step < 3000; ++step) {
            const LegTarget target = walk.next();
            CHECK(solve(limb.leg, target, pose).answer == LegAnswer::reached);
            worst = std::max(worst, error(limb.leg, pose, target));
            past = std::max(past, violation(limb.leg, pose));
        }
        INFO(limb.name);
        CHECK(worst <= 1.001e-6);  // the tolerance, and rounding
        CHECK(past == 0);
    }
}

TEST_CASE("cold, the full Jacobian finds 99.9 % of places and orientations that can be had", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    LegalPoses poses(leg);
    int missed = 0;
    for (int round = 0; round < 10000; ++round) {
        const LegTarget target = target_of(leg, poses.next());
        LegPose pose = rest_pose(leg);
        solve(leg, target, pose);
        missed += error(leg, pose, target) > 1e-4;
    }
    CHECK(missed <= 10);
}

TEST_CASE("an orientation that is not finite is refused", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    LegTarget target = target_of(leg, rest_pose(leg));
    target.orientation.y.x = std::nan("");
    LegPose pose{};
    CHECK(solve(leg, target, pose).answer == LegAnswer::refused);
    CHECK(pose == LegPose{});
}
