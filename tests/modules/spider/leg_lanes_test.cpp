#include "leg_lanes.hpp"

#include <bit>
#include <cstdint>
#include <limits>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

std::vector<Leg> legs_of(const std::string& name, std::size_t count) {
    std::vector<Leg> legs;
    const Species species = creature(name);
    while (legs.size() < count) legs.push_back(species.limbs[legs.size() % species.limbs.size()].leg);
    return legs;
}

using Bits = std::array<std::uint64_t, kJoints>;

Bits bits(const LegPose& pose) { return std::bit_cast<Bits>(pose); }

/// Legs in lanes of one kernel, and the same legs one after another.
class Twins {
public:
    Twins(std::vector<Leg> legs, const LaneKernel& kernel)
        : lanes_(legs, kernel),
          angles_(lanes_.angle_count()),
          targets_(lanes_.target_count()),
          results_(legs.size()) {
        for (std::size_t i = 0; i < legs.size(); ++i) set_pose(i, rest_pose(legs[i]));
    }

    const Leg& leg(std::size_t i) const { return lanes_.leg(i); }
    void set_pose(std::size_t i, const LegPose& pose) {
        poses_.resize(lanes_.size());
        poses_[i] = pose;
        lanes_.set_pose(angles_, i, pose);
    }

    /// How many restarts there were.
    int solve(const std::vector<Vec3>& targets, const LegSolverOptions& options = {}) {
        for (std::size_t i = 0; i < targets.size(); ++i) lanes_.set_target(targets_, i, targets[i]);
        lanes_.solve(targets_, options, angles_, results_);
        int restarts = 0;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const LegResult alone =
                find_leg_solver("half_jacobian")->solve(leg(i), {targets[i]}, options, poses_[i]);
            REQUIRE(bits(lanes_.pose(angles_, i)) == bits(poses_[i]));
            REQUIRE(results_[i].answer == alone.answer);
            REQUIRE(results_[i].error == alone.error);
            REQUIRE(results_[i].steps == alone.steps);
            REQUIRE(results_[i].restarts == alone.restarts);
            restarts += alone.restarts;
        }
        return restarts;
    }

private:
    LegLanes lanes_;
    std::vector<double> angles_, targets_;
    std::vector<LegResult> results_;
    std::vector<LegPose> poses_;
};

}  // namespace

TEST_CASE("legs in lanes end where they end one after another, to the bit", "[unit]") {
    for (const LaneKernel& kernel : lane_kernels())
        for (const std::size_t count : {1, 4, 6, 8, 19}) {
            INFO(kernel.name << ", " << count << " legs");
            Twins twins(legs_of("huntsman", count), kernel);
            std::vector<ReachableWalk> walks;
            for (std::size_t i = 0; i < count; ++i)
                walks.emplace_back(twins.leg(i), twins.leg(i).length * 0.004 * static_cast<double>(1 + i % 8));
            for (int step = 0; step < 300; ++step) {
                std::vector<Vec3> targets(count);
                for (std::size_t i = 0; i < count; ++i) targets[i] = walks[i].next().position;
                twins.solve(targets);
            }
        }
}

TEST_CASE("so do those that start again from other poses, and those that are blocked", "[unit]") {
    for (const LaneKernel& kernel : lane_kernels()) {
        INFO(kernel.name);
        Twins twins(legs_of("huntsman", 8), kernel);
        const RandomStream random(11, "anywhere");
        std::uint64_t count = 0;
        int restarts = 0;
        for (int round = 0; round < 500; ++round) {
            std::vector<Vec3> targets(8);
            for (std::size_t i = 0; i < 8; ++i) {
                const double size = 1.1 * twins.leg(i).length;
                const double x = random.uniform(count++, -size, size), y = random.uniform(count++, -size, size);
                targets[i] = {x, y, random.uniform(count++, -size, size)};
            }
            restarts += twins.solve(targets);
        }
        CHECK(restarts > 1000);
    }
}

TEST_CASE("a target without an answer leaves the lanes beside it alone", "[unit]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const LaneKernel& kernel : lane_kernels()) {
        INFO(kernel.name);
        Twins twins(legs_of("huntsman", 8), kernel);
        const auto home = [&](std::size_t i) { return foot_position(twins.leg(i), rest_pose(twins.leg(i))); };
        for (int call = 0; call < 3; ++call)
            twins.solve({{nan, 0, 0},
                         home(1),
                         {},
                         {1e300, 1e300, -1e300},
                         {0, -inf, 0},
                         0.7 * home(5),
                         {1, 1, 1},
                         {twins.leg(7).length, 0, 0}});
    }
}
