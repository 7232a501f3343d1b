#include "leg_ways.hpp"

#include <array>

namespace orbweaver::spider {

namespace {

/// Kinds of targets: how far a foot goes from one to the next, leg lengths; 0: anywhere, from the rest pose.
struct Kind {
    ReachWays::Named named;
    double step;
};
constexpr std::array<Kind, 3> kKinds{{
    {{"warm", "feet on loops, 1 % of the leg a target"}, 0.01},
    {{"hasty", "feet on loops, 5 % of the leg a target"}, 0.05},
    {{"cold", "random poses, each from the rest pose"}, 0},
}};
constexpr double kColdStep = 0.01;  // of the loops that are made beside the cold targets

constexpr std::array<ReachWays::Named, 5> kWays{{
    // as leg_solvers() has them, then the lanes
    {"half_jacobian", "damped least squares for the foot's place, one leg at a time"},
    {"full_jacobian", "the same for place and orientation of the last bone"},
    {"fabrik", "forward and backward reaching, joint limits kept"},
    {"fabrik_unlimited", "the same without joint limits"},
    {"half_jacobian_lanes", "the half Jacobian, eight legs side by side, in this processor's widest registers"},
}};

LegSolverOptions options_of(const ReachWays::Effort& effort) {
    LegSolverOptions options;
    options.tolerance = effort.tolerance;
    if (effort.steps == 0) return options;
    options.max_steps = effort.steps;
    options.restarts = 0;
    return options;
}

ReachWays::Reach reach_of(const Leg& leg, const LegTarget& target, const LegPose& pose,
                          const LegResult& result) {
    return {distance(foot_position(leg, pose), target.position) * leg.per_length,
            result.answer == LegAnswer::reached};
}

/// One call of LegWays::reach().
struct Asked {
    const FootPaths& paths;
    bool cold;
    LegSolverOptions options;
};

void one_by_one(const Asked& asked, const LegSolver& solver, std::span<ReachWays::Reach> reaches) {
    const std::vector<Leg>& legs = asked.paths.legs();
    std::vector<LegPose> poses;
    poses.reserve(legs.size());
    for (const Leg& leg : legs) poses.push_back(rest_pose(leg));
    for (std::size_t t = 0; t < FootPaths::kTimes; ++t)
        for (std::size_t i = 0; i < legs.size(); ++i) {
            if (asked.cold) poses[i] = rest_pose(legs[i]);
            const LegTarget& target = asked.paths.at(asked.cold, i, t);
            const LegResult result = solver.solve(legs[i], target, asked.options, poses[i]);
            if (!reaches.empty()) reaches[t * legs.size() + i] = reach_of(legs[i], target, poses[i], result);
        }
}

void in_lanes(const Asked& asked, std::span<ReachWays::Reach> reaches) {
    const std::vector<Leg>& legs = asked.paths.legs();
    const LegLanes lanes(legs);
    std::vector<double> angles(lanes.angle_count()), targets(lanes.target_count());
    std::vector<LegResult> results(lanes.size());
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes.set_pose(angles, i, rest_pose(legs[i]));
    for (std::size_t t = 0; t < FootPaths::kTimes; ++t) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            if (asked.cold) lanes.set_pose(angles, i, rest_pose(legs[i]));
            lanes.set_target(targets, i, asked.paths.at(asked.cold, i, t).position);
        }
        lanes.solve(targets, asked.options, angles, results);
        for (std::size_t i = 0; i < reaches.size() / FootPaths::kTimes; ++i)
            reaches[t * legs.size() + i] =
                reach_of(legs[i], asked.paths.at(asked.cold, i, t), lanes.pose(angles, i), results[i]);
    }
}

}  // namespace

std::span<const ReachWays::Named> LegWays::ways() const noexcept { return kWays; }

std::span<const ReachWays::Named> LegWays::kinds() const noexcept {
    static constexpr auto names = [] {
        std::array<Named, kKinds.size()> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = kKinds[i].named;
        return all;
    }();
    return names;
}

const FootPaths& LegWays::paths(std::size_t kind) {
    paths_.resize(kKinds.size());
    auto& made = paths_[kind];
    if (!made)
        made = std::make_unique<FootPaths>(legs_of(species_),
                                           kKinds[kind].step > 0 ? kKinds[kind].step : kColdStep);
    return *made;
}

void LegWays::reach(std::size_t way, std::size_t kind, const Effort& effort, std::span<Reach> reaches) {
    const Asked asked{paths(kind), kKinds[kind].step == 0, options_of(effort)};
    if (way < leg_solvers().size())
        one_by_one(asked, leg_solvers()[way], reaches);
    else
        in_lanes(asked, reaches);
}

}  // namespace orbweaver::spider
