// The cost of a force evaluation and of a step of each method on the thesis's web, against the
// straightforward loop over an array of structures, run in the same process.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <vector>

#include "../modules/web/sample_webs.hpp"
#include "adviser.hpp"
#include "method.hpp"
#include "packing.hpp"
#include "spring_system.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::mass_spring;

struct Bodies {
    Network network;
    std::vector<Vec3> x, v;
};

/// The web of assets/scenes/thesis_web.toml, its particles in motion.
Bodies thesis_web(double damping) {
    web::Construction how;
    how.move_outer = 75e-3;
    const web::Layout layout = web::construct(web::test::site_of(web::test::thesis_anchors()), how,
                                              RandomStream(1, "web/irregularity"));
    Bodies bodies{web::over_extend(layout, how, 1e-8, damping), layout.positions, {}};
    for (const Vec3& x : bodies.x) bodies.v.push_back({0.1 * x.y, -0.2 * x.x, 0.3 * x.x * x.y});
    return bodies;
}

/// As many springs between particles at random: no two of them are neighbours in memory.
Bodies tangle() {
    Bodies bodies = thesis_web(0);
    const RandomStream random(1, "tangle");
    std::uint64_t n = 0;
    for (Spring& s : bodies.network.springs) {
        do {
            s.a = static_cast<std::uint32_t>(random.bits(n++) % bodies.x.size());
            s.b = static_cast<std::uint32_t>(random.bits(n++) % bodies.x.size());
        } while (s.a == s.b);
    }
    return bodies;
}

/// The web with its particles numbered at random.
Bodies shuffled() {
    const Bodies web = thesis_web(0);
    const RandomStream random(1, "shuffle");
    std::vector<std::uint32_t> to(web.x.size());
    std::iota(to.begin(), to.end(), 0U);
    for (std::size_t i = to.size(); i > 1; --i) std::swap(to[i - 1], to[random.bits(i) % i]);
    Bodies mixed = web;
    for (std::size_t i = 0; i < to.size(); ++i) {
        mixed.network.mass[to[i]] = web.network.mass[i];
        mixed.network.fixed[to[i]] = web.network.fixed[i];
        mixed.x[to[i]] = web.x[i];
        mixed.v[to[i]] = web.v[i];
    }
    for (Spring& s : mixed.network.springs) {
        s.a = to[s.a];
        s.b = to[s.b];
    }
    return mixed;
}

std::vector<double> packed(const SpringSystem& system, const std::vector<Vec3>& vectors) {
    std::vector<double> flat(system.length());
    system.packing().pack(vectors, flat);
    return flat;
}

/// The peer: one structure per spring, forces added to both ends as they come.
void naive_accelerations(const Bodies& body, std::vector<Vec3>& a) {
    for (Vec3& each : a) each = {};
    for (const Spring& s : body.network.springs) {
        const Vec3 l = body.x[s.a] - body.x[s.b];
        const Vec3 dl = body.v[s.a] - body.v[s.b];
        const double length = norm(l);
        const Vec3 f =
            l * ((s.stiffness * (length - s.rest_length) + s.damping * dot(dl, l) / length) / length);
        a[s.a] -= f;
        a[s.b] += f;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = body.network.fixed[i] != 0 ? Vec3{} : (a[i] - 1e-8 * body.v[i]) / body.network.mass[i];
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
void report(benchmark::State& state, const Bodies& body, double best, double peer) {
    const auto springs = static_cast<double>(body.network.springs.size());
    state.counters["best_ns_per_spring"] = 1e9 * best / springs;
    state.counters["peer_best_ns_per_spring"] = 1e9 * peer / springs;
    state.counters["times_faster_than_peer"] = peer / best;
}

double peer_seconds(const Bodies& body) {
    std::vector<Vec3> a(body.x.size());
    return best_seconds([&] {
        naive_accelerations(body, a);
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    });
}

void forces(benchmark::State& state, const Bodies& body, const SpringKernels* kernels) {
    if (kernels == nullptr) return state.SkipWithError("this processor has no such instructions");
    SpringSystem system(body.network, nullptr);
    system.use_kernels(*kernels);
    system.set_surroundings({{}, 1e-8, {}});
    const std::vector<double> x = packed(system, body.x), v = packed(system, body.v);
    std::vector<double> a(system.length());
    const auto call = [&] {
        system.accelerations(x, v, a);
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    };
    for (auto _ : state) call();
    report(state, body, best_seconds(call), peer_seconds(body));
}

/// A whole step, counted per spring and evaluation: what stands above `forces` is the method's own work.
void step(benchmark::State& state, const char* name) {
    const Bodies body = thesis_web(0);
    SpringSystem system(body.network, nullptr);
    std::vector<double> x = packed(system, body.x), v = packed(system, body.v);
    const MethodInfo& info = *find_method(name);
    const auto method = info.make(system.length());
    const auto call = [&] { method->step(system, x, v, 1e-9); };
    for (auto _ : state) call();
    report(state, body, best_seconds(call) / info.evaluations, peer_seconds(body));
}

void advice(benchmark::State& state, const char* name, double damping) {
    const Bodies body = thesis_web(damping);
    const SpringSystem system(body.network, nullptr);
    for (auto _ : state) benchmark::DoNotOptimize(advise(system, body.x, *find_method(name)).stable_step);
}

BENCHMARK_CAPTURE(forces, plain_undamped, thesis_web(0), &plain_kernels());
BENCHMARK_CAPTURE(forces, plain_damped, thesis_web(1e-6), &plain_kernels());
BENCHMARK_CAPTURE(forces, wide_undamped, thesis_web(0), wide_kernels());
BENCHMARK_CAPTURE(forces, wide_damped, thesis_web(1e-6), wide_kernels());
BENCHMARK_CAPTURE(forces, wide_shuffled, shuffled(), wide_kernels());
BENCHMARK_CAPTURE(forces, wide_tangle, tangle(), wide_kernels());
BENCHMARK_CAPTURE(step, explicit_euler, "explicit_euler");
BENCHMARK_CAPTURE(step, symplectic_euler, "symplectic_euler");
BENCHMARK_CAPTURE(step, rk4, "rk4");
BENCHMARK_CAPTURE(advice, rk4_undamped, "rk4", 0);
BENCHMARK_CAPTURE(advice, rk4_damped, "rk4", 1e-6);

}  // namespace

BENCHMARK_MAIN();
