#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "leg_lanes.hpp"
#include "orbweaver/fault.hpp"
#include "orbweaver/random.hpp"
#include "species.hpp"

namespace orbweaver::spider::test {

/// What a creature's solvers are asked for: feet that go round loops of a stride's shape, a share of the leg's
/// length at a time (warm), and places that random poses within limits reach (cold). In the legs' own frames,
/// m.
struct FootPaths {
    static constexpr std::size_t kTimes = 256;

    explicit FootPaths(const std::string& species, double step) {
        Diagnostics faults;
        const auto read =
            read_species_file(ORBWEAVER_SOURCE_DIR "/assets/creatures/" + species + ".toml", faults);
        if (!read) throw Fault(FaultKind::invalid, to_string(faults.front()));
        const RandomStream random(1, "poses");
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < read->limbs.size(); ++i) {
            const Leg& leg = read->limbs[i].leg;
            legs.push_back(leg);
            const Vec3 home = foot_position(leg, rest_pose(leg));
            LegPose along = rest_pose(leg);
            const double rounds = std::ceil(kTimes * step / (2 * std::numbers::pi * 0.25));
            const double radius = leg.length * step * kTimes / (2 * std::numbers::pi * rounds);
            for (std::size_t t = 0; t < kTimes; ++t) {
                const double phase =
                    2 * std::numbers::pi * rounds * static_cast<double>(t) / kTimes + static_cast<double>(i);
                const Vec3 foot = home + Vec3{0, 0.3 * radius * std::sin(phase), radius * std::cos(phase)};
                find_leg_solver("half_jacobian")->solve(leg, {foot}, {}, along);
                warm.push_back(target_of(leg, along));
                LegPose pose;
                for (std::size_t j = 0; j < kJoints; ++j)
                    pose[j] = leg.min[j] + (leg.max[j] - leg.min[j]) * random.uniform(count++);
                cold.push_back(target_of(leg, pose));
            }
        }
    }

    /// Of leg i at time t.
    const LegTarget& at(bool cold_ones, std::size_t i, std::size_t t) const {
        return (cold_ones ? cold : warm)[i * kTimes + t];
    }

    std::vector<Leg> legs;
    std::vector<LegTarget> warm, cold;

private:
    static LegTarget target_of(const Leg& leg, const LegPose& pose) {
        return {foot_position(leg, pose), foot_frame(leg, pose)};
    }
};

}  // namespace orbweaver::spider::test
