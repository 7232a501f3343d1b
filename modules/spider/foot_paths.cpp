#include "foot_paths.hpp"

#include <cmath>
#include <numbers>

#include "orbweaver/random.hpp"

namespace orbweaver::spider {

namespace {

LegTarget target_of(const Leg& leg, const LegPose& pose) {
    return {foot_position(leg, pose), foot_frame(leg, pose)};
}

}  // namespace

FootPaths::FootPaths(std::span<const Leg> legs, double step) : legs_(legs.begin(), legs.end()) {
    constexpr double kAround = 2 * std::numbers::pi;
    const RandomStream random(1, "poses");
    std::uint64_t count = 0;
    const double rounds = std::ceil(kTimes * step / (kAround * 0.25));
    for (std::size_t i = 0; i < legs_.size(); ++i) {
        const Leg& leg = legs_[i];
        const Vec3 home = foot_position(leg, rest_pose(leg));
        LegPose along = rest_pose(leg);
        const double radius = leg.length * step * kTimes / (kAround * rounds);
        for (std::size_t t = 0; t < kTimes; ++t) {
            const double phase = kAround * rounds * static_cast<double>(t) / kTimes + static_cast<double>(i);
            const Vec3 foot = home + Vec3{0, 0.3 * radius * std::sin(phase), radius * std::cos(phase)};
            find_leg_solver("half_jacobian")->solve(leg, {foot, {}}, {}, along);
            warm_.push_back(target_of(leg, along));
            LegPose pose;
            for (std::size_t j = 0; j < kJoints; ++j)
                pose[j] = leg.min[j] + (leg.max[j] - leg.min[j]) * random.uniform(count++);
            cold_.push_back(target_of(leg, pose));
        }
    }
}

}  // namespace orbweaver::spider
