#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "leg_solver.hpp"
#include "orbweaver/random.hpp"
#include "species.hpp"

namespace orbweaver::spider::test {

inline const std::array<std::string, 6> kCreatures{"huntsman",   "tarantula", "jumping_spider",
                                                   "harvestman", "ant",       "lizard"};

inline Species creature(const std::string& name) {
    Diagnostics faults;
    const auto species = read_species_file(ORBWEAVER_SOURCE_DIR "/assets/creatures/" + name + ".toml", faults);
    for (const Diagnostic& fault : faults) UNSCOPED_INFO(to_string(fault));
    REQUIRE(faults.empty());
    REQUIRE(species.has_value());
    return *species;
}

/// Poses drawn uniformly from what limits allow, one after another.
class LegalPoses {
public:
    explicit LegalPoses(const Leg& leg, const char* name = "poses") : leg_(leg), stream_(7, name) {}

    LegPose next() {
        LegPose pose;
        for (std::size_t j = 0; j < kJoints; ++j)
            pose[j] = leg_.min[j] + (leg_.max[j] - leg_.min[j]) * stream_.uniform(count_++);
        return pose;
    }

private:
    Leg leg_;
    RandomStream stream_;
    std::uint64_t count_ = 0;
};

inline LegTarget target_of(const Leg& leg, const LegPose& pose) {
    return {foot_position(leg, pose), foot_frame(leg, pose)};
}

/// Targets in steps of at most `stride` (m) along a walk through legal poses: all of them can be reached.
class ReachableWalk {
public:
    ReachableWalk(const Leg& leg, double stride)
        : leg_(leg), stride_(stride), poses_(leg, "walk"), at_(rest_pose(leg)) {}

    LegTarget next() {
        const Vec3 from = foot_position(leg_, at_);
        const LegPose towards = poses_.next();
        LegPose pose = towards;
        for (double share = 1; distance(from, foot_position(leg_, pose)) > stride_; share /= 2)
            for (std::size_t j = 0; j < kJoints; ++j) pose[j] = at_[j] + share / 2 * (towards[j] - at_[j]);
        at_ = pose;
        return target_of(leg_, at_);
    }

private:
    Leg leg_;
    double stride_;
    LegalPoses poses_;
    LegPose at_;
};

}  // namespace orbweaver::spider::test
