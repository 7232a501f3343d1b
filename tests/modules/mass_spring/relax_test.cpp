#include "relax.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("a hanging thread sags as a catenary and its anchors bear its weight", "[unit]") {
    // 2 c sinh(D/(2 c)) = L, sag = c (cosh(D/(2 c)) - 1): 27.18 mm for D = 0.19 m, L = 0.20 m.
    constexpr double kSpan = 0.19, kLength = 0.20, kSag = 27.18e-3, kMass = 1e-5;
    Body body = bodies::hanging_thread(60, kSpan, kLength, kMass, 600);  // EA = 2 N, 20000 times the weight
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    const double weight = 9.81 * kMass;
    const Relaxation result = relax(system, body.x, 1e-7 * weight, 200000);
    REQUIRE(result.converged);
    double lowest = 0;
    for (const Vec3& x : body.x) lowest = std::min(lowest, x.y);
    CHECK(-lowest == Approx(kSag).epsilon(0.005));

    std::vector<Vec3> f(body.x.size());
    system.forces(body.x, body.v, f);
    // A net force on a fixed particle is what its anchor holds against: both together, the whole weight.
    CHECK(-(f.front().y + f.back().y) == Approx(weight).epsilon(1e-3));
    CHECK(std::abs(f.front().x + f.back().x) < 1e-3 * weight);
}

TEST_CASE("a load on a taut thread is held by P = 2 (T + EA d) sin(theta)", "[unit]") {
    constexpr std::uint32_t kHalf = 20;
    constexpr double kTension = 0.3e-3, kStiffness = 10, kLink = 5e-3, kLoad = 0.05e-3;
    Body body = bodies::bead_string(2 * kHalf - 1, kLink, 1e-9, kStiffness, kTension);
    SpringSystem system(body.network, nullptr);
    std::vector<Vec3> load(body.x.size());
    load[kHalf].y = -kLoad;
    system.set_surroundings({{}, 0, load});
    REQUIRE(relax(system, body.x, 1e-7 * kLoad, 200000).converged);

    const double half_span = kHalf * kLink;
    const double sag = -body.x[kHalf].y;
    const double half_length = std::sqrt(half_span * half_span + sag * sag);
    const double added_strain = half_length / half_span - 1;
    const double ea = kStiffness * kLink;
    const double held = 2 * (kTension + ea * added_strain) * sag / half_length;
    CHECK(held == Approx(kLoad).epsilon(0.005));
    CHECK(tension(body.network.springs[0], body.x) == Approx(kTension + ea * added_strain).epsilon(0.005));
}

TEST_CASE("slack springs do not keep a body from its rest", "[unit]") {
    // A weight on a taut spring, and beside it a chain much too long, that hangs slack below.
    Body body;
    const auto top = body.add({0, 0, 0}, 1e-6, true);
    const auto weight = body.add({0, -0.1, 0}, 1e-6);
    body.join(top, weight, 0.1, 1);
    auto before = top;
    for (int i = 0; i < 8; ++i) {
        const auto next = body.add({0.001 * (i + 1), -0.01 * (i + 1), 0}, 1e-9);
        body.join(before, next, 0.03, 1);
        before = next;
    }
    body.join(before, weight, 0.03, 1);
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    const Relaxation result = relax(system, body.x, 1e-11, 200000);
    CHECK(result.converged);
    for (const Vec3& x : body.x) CHECK(is_finite(x));
}

TEST_CASE("a relaxation that cannot end says so", "[extreme]") {
    Body body;
    body.add({0, 0, 0}, 1);  // nothing holds it
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -10, 0}, 0, {}});
    const Relaxation result = relax(system, body.x, 1e-9, 100);
    CHECK_FALSE(result.converged);
    CHECK(result.iterations == 100);
    CHECK(result.residual == Approx(10));
    CHECK(body.x[0] == Vec3{});
}

TEST_CASE("a body at rest is not touched", "[unit]") {
    Body body = bodies::bead_string(5, 0.01, 1e-6, 1, 1e-3);
    const auto before = body.x;
    SpringSystem system(body.network, nullptr);
    const Relaxation result = relax(system, body.x, 1e-12, 100);
    CHECK(result.converged);
    CHECK(result.iterations == 0);
    CHECK(bodies::same_bits(before, body.x));
}
