// The cost of a leg for each solver: the huntsman's legs, feet that move by a hundredth of their length a call
// (warm), and targets anywhere within reach from the rest pose (cold). Time is of one leg.

#include <benchmark/benchmark.h>

#include <string>

#include "foot_paths.hpp"
#include "leg_lanes.hpp"
#include "species_legs.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::spider;

const FootPaths& paths() {
    static const FootPaths made(spider::test::species_legs("huntsman"), 0.01);
    return made;
}

void count_legs(benchmark::State& state, std::size_t legs, std::size_t reached) {
    const double solved = static_cast<double>(state.iterations()) * static_cast<double>(legs);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(legs));
    state.counters["s_a_leg"] =
        benchmark::Counter(solved, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["reached"] = static_cast<double>(reached) / solved;
}

void one_by_one(benchmark::State& state, const LegSolver& solver, bool cold) {
    const FootPaths& all = paths();
    std::vector<LegPose> poses;
    for (const Leg& leg : all.legs()) poses.push_back(rest_pose(leg));
    std::size_t t = 0, reached = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < all.legs().size(); ++i) {
            if (cold) poses[i] = rest_pose(all.legs()[i]);
            const LegTarget& target = all.at(cold, i, t);
            reached += solver.solve(all.legs()[i], target, {}, poses[i]).answer == LegAnswer::reached;
        }
        t = (t + 1) % FootPaths::kTimes;
    }
    count_legs(state, all.legs().size(), reached);
}

void in_lanes(benchmark::State& state, const LaneKernel& kernel, bool cold) {
    const FootPaths& all = paths();
    const LegLanes lanes(all.legs(), kernel);
    std::vector<double> angles(lanes.angle_count()), targets(lanes.target_count());
    std::vector<LegResult> results(lanes.size());
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes.set_pose(angles, i, rest_pose(lanes.leg(i)));
    std::size_t t = 0, reached = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            if (cold) lanes.set_pose(angles, i, rest_pose(lanes.leg(i)));
            lanes.set_target(targets, i, all.at(cold, i, t).position);
        }
        lanes.solve(targets, {}, angles, results);
        for (const LegResult& result : results) reached += result.answer == LegAnswer::reached;
        t = (t + 1) % FootPaths::kTimes;
    }
    count_legs(state, lanes.size(), reached);
}

void add_all() {
    for (const bool cold : {false, true}) {
        const std::string how = cold ? "/cold" : "/warm";
        for (const LegSolver& solver : leg_solvers())
            benchmark::RegisterBenchmark((std::string(solver.name) + how).c_str(), one_by_one, solver, cold);
        for (const LaneKernel& kernel : lane_kernels())
            benchmark::RegisterBenchmark(("lanes_" + std::string(kernel.name) + how).c_str(), in_lanes, kernel,
                                         cold);
    }
}

}  // namespace

int main(int argc, char** argv) {
    add_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
