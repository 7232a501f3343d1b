// The cost of a query of the surface for each way of asking, over the bunny: 70,000 triangles.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "../modules/surface/walk_samples.hpp"
#include "fcl_clearance.hpp"
#include "fcl_tree.hpp"
#include "stride.hpp"
#include "underfoot.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::surface;

const test::WalkSamples& samples() {
    static const test::WalkSamples made(ORBWEAVER_MESHES "/stanford-bunny.obj");
    return made;
}

/// Calls `ask` with each sample in turn.
template <class Samples, class Ask>
void each(benchmark::State& state, const Samples& all, Ask&& ask) {
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ask(all[i]));
        i = i + 1 == all.size() ? 0 : i + 1;
    }
}

void underfoot_walking(benchmark::State& state) {
    const auto& s = samples();
    each(state, s.stances, [&](const Stance& stance) { return underfoot(s.mesh, s.parts, stance); });
}

void ray_wide_tree(benchmark::State& state, const std::vector<SurfaceRay>& rays) {
    const auto& s = samples();
    each(state, rays, [&](const SurfaceRay& ray) { return first_hit(*s.parts.tree(), s.set, ray); });
}

void ray_fcl_tree(benchmark::State& state, const std::vector<SurfaceRay>& rays) {
    const auto& s = samples();
    static const FclTree fcl(s.set);
    each(state, rays, [&](const SurfaceRay& ray) { return fcl.first_hit(ray); });
}

void nearest_point(benchmark::State& state) {
    const auto& s = samples();
    each(state, s.stances, [&](const Stance& stance) {
        return closest_point(*s.parts.tree(), s.set, stance.position, stance.reach);
    });
}

void walk_step(benchmark::State& state) {
    const auto& s = samples();
    each(state, s.footings, [&](const Footing& from) { return step(s.mesh, from, s.step_length); });
}

void stride_ray(benchmark::State& state) {
    const auto& s = samples();
    std::array<StrideCorner, 16> corners;
    each(state, s.footings,
         [&](const Footing& from) { return stride(s.mesh, 1, s.parts, from, 10 * s.step_length, corners); });
}

void sphere_clearance(benchmark::State& state) {
    const auto& s = samples();
    static const FclClearance fcl(s.set);
    each(state, s.stances, [&](const Stance& stance) {
        ProbeBody body;
        body.center = stance.position;
        body.size.x = 0.2 * s.height;
        return fcl.clearance(body, stance.reach);
    });
}

void build_tree(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(build_wide_tree(samples().set));
}

void build_fcl_tree(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(FclTree(samples().set).memory_bytes());
}

BENCHMARK(underfoot_walking);
BENCHMARK_CAPTURE(ray_wide_tree, short_down, samples().short_rays);
BENCHMARK_CAPTURE(ray_fcl_tree, short_down, samples().short_rays);
BENCHMARK_CAPTURE(ray_wide_tree, across, samples().long_rays);
BENCHMARK_CAPTURE(ray_fcl_tree, across, samples().long_rays);
BENCHMARK(nearest_point);
BENCHMARK(walk_step);
BENCHMARK(stride_ray);
BENCHMARK(sphere_clearance);
BENCHMARK(build_tree)->Unit(benchmark::kMillisecond);
BENCHMARK(build_fcl_tree)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
