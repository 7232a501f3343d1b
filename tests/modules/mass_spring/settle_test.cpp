#include "settle.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "orbweaver/random.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// Moves what is free by up to `size` m.
void shake(Body& body, double size) {
    const RandomStream random(7, "shake");
    for (std::size_t i = 0; i < body.x.size(); ++i) {
        if (body.network.fixed[i] != 0) continue;
        body.x[i] += Vec3{random.uniform(3 * i, -size, size), random.uniform(3 * i + 1, -size, size),
                          random.uniform(3 * i + 2, -size, size)};
    }
}

/// A taut square net of n x n, its rim fixed.
Body taut_net(std::uint32_t n) {
    Body body;
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const std::uint32_t row = i / n, column = i % n;
        const bool rim = row == 0 || column == 0 || row == n - 1 || column == n - 1;
        body.add({0.01 * column, 0.01 * row, 0}, 1e-8, rim);
    }
    for (std::uint32_t i = 0; i < n * n; ++i) {
        if (i % n + 1 < n) body.join(i, i + 1, 0.009, 0.1);
        if (i + n < n * n) body.join(i, i + n, 0.009, 0.1);
    }
    return body;
}

}  // namespace

TEST_CASE("a hanging thread settles into a catenary", "[unit]") {
    // 2 c sinh(D/(2 c)) = L, sag = c (cosh(D/(2 c)) - 1): 27.18 mm for D = 0.19 m, L = 0.20 m.
    Body body = bodies::hanging_thread(60, 0.19, 0.20, 1e-5, 600);
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    const Settlement result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.residual <= 1e-12);
    double lowest = 0;
    for (const Vec3& x : body.x) lowest = std::min(lowest, x.y);
    CHECK(-lowest == Approx(27.18e-3).epsilon(0.005));
}

TEST_CASE("a shaken net comes back to where it rested, and a load moves it", "[unit]") {
    Body body = taut_net(20);
    const auto rest = body.x;
    shake(body, 1e-3);
    std::vector<Vec3> load(body.x.size());
    SpringSystem system(body.network, nullptr);
    Settlement result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.relaxations == 0);
    double farthest = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) farthest = std::max(farthest, distance(rest[i], body.x[i]));
    CHECK(farthest < 1e-9);

    load[210] = {0, 0, 1e-4};
    system.set_surroundings({{}, 0, load});
    result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.iterations < 20);  // quadratic convergence
    CHECK(body.x[210].z > 1e-4);
}

TEST_CASE("with either solver a body settles to the same place", "[unit]") {
    // The thread is laid shorter than it is, and the net shaken by half of what is between its particles: at
    // first, neither's matrix is positive definite.
    Body net = taut_net(20);
    shake(net, 5e-3);
    for (const Body& start : {net, bodies::hanging_thread(20, 0.19, 0.20, 1e-5, 600)}) {
        Body direct = start, iterative = start;
        for (auto [body, kind] : {std::pair(&direct, LinearSolverKind::cholesky),
                                  std::pair(&iterative, LinearSolverKind::conjugate_gradients)}) {
            SpringSystem system(body->network, nullptr);
            system.set_surroundings({{0, -9.81, 0}, 0, {}});
            system.use_linear_solver(kind);
            const Settlement result = settle(system, body->x);
            CHECK(result.converged);
            CHECK(result.relaxations == 0);
        }
        for (std::size_t i = 0; i < start.x.size(); ++i) CHECK(distance(direct.x[i], iterative.x[i]) < 1e-8);
        CHECK_FALSE(bodies::same_bits(direct.x, iterative.x));
    }
}

TEST_CASE("a lattice that is thick in three directions settles without a factor", "[extreme]") {
    // A factor would take 2e9 updates, whose list alone is of 8 GB.
    const auto peak_megabytes = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss / 1024;
    };
    Body body = bodies::lattice(30, 0.1);
    const auto rest = body.x;
    shake(body, 1e-3);
    const auto before = peak_megabytes();
    SpringSystem system(body.network, nullptr);
    const Settlement result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.relaxations == 0);
    double farthest = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) farthest = std::max(farthest, distance(rest[i], body.x[i]));
    CHECK(farthest < 1e-9);
    CHECK(peak_megabytes() - before < 300);
}

TEST_CASE("slack nets settle too", "[unit]") {
    // Springs twice as long as their places: all of it in compression at first.
    Body body = taut_net(12);
    for (Spring& s : body.network.springs) s.rest_length = 0.02;
    shake(body, 1e-4);
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, 0, -9.81}, 0, {}});
    const Settlement result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.residual <= 1e-12);
    CHECK(body.x[66].z < -1e-3);
}

TEST_CASE("what nothing holds does not come to rest, and stays finite", "[extreme]") {
    Body alone;
    alone.add({1, 2, 3}, 1);
    Body falling = bodies::tangle(10, 0);
    for (Body* body : {&alone, &falling}) {
        SpringSystem system(body->network, nullptr);
        system.set_surroundings({{0, -1e6, 0}, 0, {}});
        CHECK_FALSE(settle(system, body->x).converged);
        for (const Vec3& x : body->x) CHECK(is_finite(x));
    }
    CHECK(alone.x[0] == Vec3{1, 2, 3});
}

TEST_CASE("stiff bodies settle to what rounding leaves of them", "[extreme]") {
    Body body = taut_net(10);
    for (Spring& s : body.network.springs) s.stiffness *= 1e9;
    shake(body, 1e-4);
    SpringSystem system(body.network, nullptr);
    const Settlement result = settle(system, body.x);
    CHECK(result.converged);
    CHECK(result.tolerance > 1e-12);
    CHECK(result.tolerance < 1e-4);  // beside forces of 1e5 N
}
