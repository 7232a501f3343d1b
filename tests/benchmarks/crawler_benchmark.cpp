// What muscles and ground add to a step of springs: a hundred worms of 20 segments on a floor by symplectic
// Euler, beside the same springs alone, which is their peer. Time is of one step; "s_a_second" is that of a
// second of theirs.

#include <benchmark/benchmark.h>

#include <vector>

#include "crawl.hpp"
#include "mass_spring/integrator.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::crawler;

constexpr int kSteps = 26;                                    // a frame, each 0.7 of the longest that is stable
constexpr double kFrame = 1.0 / 60, kStep = kFrame / kSteps;  // s

struct Worms {
    Build build = worm();
    Lattice lattice{100, build.segments};
    mass_spring::Network network = make_network(lattice, build);
    std::vector<Vec3> x = straight_points(lattice, build, poses());
    std::vector<Vec3> v = std::vector<Vec3>(x.size()), reaction = v, turned = v, step_x = x, step_v = v;
    mass_spring::SpringSystem system{network, nullptr};
    mass_spring::Integrator integrator{system, *mass_spring::find_method("symplectic_euler")};

    Worms() { system.set_surroundings({{0, -9.81, 0}, 0, {}}); }

private:
    /// As assets/crawlers/worm.toml has it.
    static Build worm() {
        Build made{20, 0.12, 0.006, 0.12 * 0.006 * 0.006 * 1000, 0, 0, true};
        constexpr double kUnit = 0.004;
        made.stiffness = 1.5 * made.point_mass() / (kUnit * kUnit);
        made.damping = 0.9 * made.point_mass() / kUnit;
        return made;
    }
    std::vector<Pose> poses() const {
        std::vector<Pose> all;
        for (std::uint32_t i = 0; i < lattice.bodies; ++i)
            all.push_back({{0, build.width / 2, 0.03 * i}, {1, 0, 0}, {0, 1, 0}});
        return all;
    }
};

void count_frames(benchmark::State& state) {
    const double seconds = kFrame * static_cast<double>(state.iterations());
    state.counters["s_a_second"] =
        benchmark::Counter(seconds, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void springs_alone(benchmark::State& state) {
    Worms worms;
    worms.system.set_surroundings({});
    for (auto _ : state) worms.integrator.advance(worms.x, worms.v, kStep, kSteps);
    count_frames(state);
}

void crawling(benchmark::State& state) {
    Worms worms;
    Crawl crawl(worms.system, worms.lattice, worms.build,
                Waves(*find_gait("rectilinear"), WaveForm::sine, 2, worms.build.segments),
                {FrictionLaw::coulomb, 0.1, 0.4, 0.3, 0}, Floor{0},
                {worms.reaction, worms.turned, worms.step_x, worms.step_v},
                *mass_spring::find_method("symplectic_euler"), nullptr);
    Drive drive;
    drive.effort = {Effort{0.15, 0, 0, 0}, Effort{0.15, 0, 0, 0}};
    const std::vector<Drive> still(worms.lattice.bodies, drive);
    double time = 0;
    for (auto _ : state) {
        std::vector<Drive> drives = still;
        for (Drive& each : drives) each.cycles = {time / 2, (time + kFrame) / 2};
        crawl.begin_frame(drives, worms.x, worms.v, kFrame);
        crawl.rewind();
        worms.integrator.advance(worms.x, worms.v, kStep, kSteps);
        crawl.keep();
        time += kFrame;
    }
    count_frames(state);
}

BENCHMARK(springs_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(crawling)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
