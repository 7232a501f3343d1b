#include <benchmark/benchmark.h>

#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

// One frame of a shipped scene, headless; the counter is simulated seconds a second.
void frames_of(benchmark::State& state, const std::string& name, int threads) {
    Request request;
    request.threads = threads;
    const OpenScene scene = open_scene(name, request);
    for (auto _ : state) scene.session->step();
    state.counters["real_time_factor"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * scene.session->scene().step, benchmark::Counter::kIsRate);
}

}  // namespace

int main(int argc, char** argv) {
    for (const std::string& name : shipped_scenes())
        for (const int threads : {1, 2})
            benchmark::RegisterBenchmark(
                ("scene/" + name + "/threads:" + std::to_string(threads)).c_str(),
                [name, threads](benchmark::State& state) { frames_of(state, name, threads); })
                ->Unit(benchmark::kMillisecond)
                ->MeasureProcessCPUTime()
                ->UseRealTime();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
