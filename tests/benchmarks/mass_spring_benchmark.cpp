// The cost of a force evaluation and of a step of each method on a web-sized network, against the
// straightforward loop over an array of structures, run in the same process.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "adviser.hpp"
#include "method.hpp"
#include "spring_system.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::mass_spring;

struct Web {
    Network network;
    std::vector<Vec3> x, v;
};

/// 40 spokes crossed by a spiral of 50 turns that is cut here and there: 2001 particles, 3714 springs.
Web make_web(double damping) {
    constexpr std::uint32_t kSpokes = 40, kTurns = 50;
    Web web;
    const auto add = [&](const Vec3& x, bool fixed) {
        web.network.mass.push_back(1e-8);
        web.network.fixed.push_back(fixed ? 1 : 0);
        web.x.push_back(x);
        web.v.push_back({0.1 * x.y, -0.2 * x.x, 0.3 * x.x * x.y});
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        web.network.springs.push_back({a, b, 0.95 * distance(web.x[a], web.x[b]), 0.01, damping});
    };
    add({}, false);
    for (std::uint32_t i = 0; i < kSpokes * kTurns; ++i) {
        const double angle = 2 * 3.14159265358979 * i / kSpokes;
        const double radius = 0.01 + 0.002 * i / kSpokes;
        add({radius * std::cos(angle), radius * std::sin(angle), 0}, i >= kSpokes * (kTurns - 1));
    }
    for (std::uint32_t s = 1; s <= kSpokes; ++s) {
        join(0, s);
        for (std::uint32_t t = 1; t < kTurns; ++t) join(s + (t - 1) * kSpokes, s + t * kSpokes);
    }
    for (std::uint32_t i = 1; i < kSpokes * kTurns; ++i) {
        if (i % 7 != 0) join(i, i + 1);
    }
    return web;
}

/// The peer: one structure per spring, forces added to both ends as they come.
void naive_accelerations(const Web& web, std::vector<Vec3>& a) {
    for (Vec3& each : a) each = {};
    for (const Spring& s : web.network.springs) {
        const Vec3 l = web.x[s.a] - web.x[s.b];
        const Vec3 dl = web.v[s.a] - web.v[s.b];
        const double length = norm(l);
        const Vec3 f =
            l * ((s.stiffness * (length - s.rest_length) + s.damping * dot(dl, l) / length) / length);
        a[s.a] -= f;
        a[s.b] += f;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = web.network.fixed[i] != 0 ? Vec3{} : (a[i] - 1e-8 * web.v[i]) / web.network.mass[i];
    }
}

template <class Call>
double best_seconds(Call&& call) {
    using Clock = std::chrono::steady_clock;
    double best = 1;
    for (int i = 0; i < 200; ++i) {
        const auto start = Clock::now();
        for (int j = 0; j < 20; ++j) call();
        best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count() / 20);
    }
    return best;
}

/// Per spring: the mean that the framework measures, the best, and how many times the peer's best is longer.
void report(benchmark::State& state, const Web& web, double best, double peer) {
    const auto springs = static_cast<double>(web.network.springs.size());
    state.counters["best_ns_per_spring"] = 1e9 * best / springs;
    state.counters["peer_best_ns_per_spring"] = 1e9 * peer / springs;
    state.counters["times_faster_than_peer"] = peer / best;
}

double peer_seconds(const Web& web) {
    std::vector<Vec3> a(web.x.size());
    return best_seconds([&] {
        naive_accelerations(web, a);
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    });
}

void forces(benchmark::State& state, double damping, const SpringKernels* kernels) {
    if (kernels == nullptr) return state.SkipWithError("this processor has no such instructions");
    const Web web = make_web(damping);
    SpringSystem system(web.network, nullptr);
    system.use_kernels(*kernels);
    system.set_surroundings({{}, 1e-8, {}});
    std::vector<Vec3> a(web.x.size());
    const auto call = [&] {
        system.accelerations(web.x, web.v, a);
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    };
    for (auto _ : state) call();
    report(state, web, best_seconds(call), peer_seconds(web));
}

/// A whole step, counted per spring and evaluation: what stands above `forces` is the method's own work.
void step(benchmark::State& state, const char* name) {
    Web web = make_web(0);
    SpringSystem system(web.network, nullptr);
    const MethodInfo& info = *find_method(name);
    const auto method = info.make(web.x.size());
    const auto call = [&] { method->step(system, web.x, web.v, 1e-9); };
    for (auto _ : state) call();
    report(state, web, best_seconds(call) / info.evaluations, peer_seconds(web));
}

void advice(benchmark::State& state, const char* name, double damping) {
    const Web web = make_web(damping);
    const SpringSystem system(web.network, nullptr);
    for (auto _ : state) benchmark::DoNotOptimize(advise(system, web.x, *find_method(name)).stable_step);
}

BENCHMARK_CAPTURE(forces, plain_undamped, 0, &plain_kernels());
BENCHMARK_CAPTURE(forces, plain_damped, 1e-6, &plain_kernels());
BENCHMARK_CAPTURE(forces, avx2_undamped, 0, avx2_kernels());
BENCHMARK_CAPTURE(forces, avx2_damped, 1e-6, avx2_kernels());
BENCHMARK_CAPTURE(step, explicit_euler, "explicit_euler");
BENCHMARK_CAPTURE(step, symplectic_euler, "symplectic_euler");
BENCHMARK_CAPTURE(step, rk4, "rk4");
BENCHMARK_CAPTURE(advice, rk4_undamped, "rk4", 0);
BENCHMARK_CAPTURE(advice, rk4_damped, "rk4", 1e-6);

}  // namespace

BENCHMARK_MAIN();
