#include <array>
#include <catch2/catch.hpp>
#include <complex>

#include "adviser.hpp"
#include "bodies.hpp"
#include "settle.hpp"
#include "simulation.hpp"
#include "spring_force.hpp"
#include "step_bound.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kMass = 0.5, kStiffness = 50, kArm = 30, kTime = 0.04;  // kg, N/m, N/m, s

Body relaxing_oscillator() {
    Body body = bodies::oscillator(kMass, kStiffness);
    body.network.springs[0].law = {0, 0, kArm, kTime};
    return body;
}

/// Where a mass on a standard linear solid is after `time`, pulled out by 1 m from a relaxed start:
/// m x'' = -k x - y,  y' = k1 x' - y/tau, so that x = sum c_i exp(s_i t) over the roots of
/// m tau s^3 + m s^2 + (k + k1) tau s + k = 0. The dashpot's extension starts at that of the spring: y = 0.
double place_after(double time) {
    using Complex = std::complex<double>;
    const std::array<double, 4> c{kMass * kTime, kMass, (kStiffness + kArm) * kTime, kStiffness};
    std::array<Complex, 3> s{Complex{1, 0}, Complex{0.4, 0.9}, Complex{-0.65, 0.72}};
    for (int round = 0; round < 500; ++round)  // Durand and Kerner
        for (std::size_t i = 0; i < 3; ++i) {
            const Complex value = ((s[i] + c[1] / c[0]) * s[i] + c[2] / c[0]) * s[i] + c[3] / c[0];
            s[i] -= value / ((s[i] - s[(i + 1) % 3]) * (s[i] - s[(i + 2) % 3]));
        }
    // x(0) = 1, x'(0) = 0, x''(0) = -k/m.
    Complex x;
    for (std::size_t i = 0; i < 3; ++i) {
        const Complex p = s[(i + 1) % 3], q = s[(i + 2) % 3];
        x += (p * q - kStiffness / kMass) / ((s[i] - p) * (s[i] - q)) * std::exp(s[i] * time);
    }
    return x.real();
}

/// The same by a method of integration.
double found_after(double time, const char* method, std::int64_t steps) {
    Body body = relaxing_oscillator();
    SpringSystem system(body.network, nullptr);
    body.x[1].x += 0.1;
    system.put_on_arms(body.x);
    Integrator(system, *find_method(method)).advance(body.x, body.v, time / static_cast<double>(steps), steps);
    return (body.x[1].x - 1) / 0.1;
}

SimulationSettings settings_of(const char* method, double step) {
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = step;
    return settings;
}

}  // namespace

TEST_CASE("a curved spring bears k e (1 - a e + b e^2) when stretched, and k e when pressed", "[unit]") {
    const Spring s{0, 1, 2, 10, 0, {0.5, 0.25, 0, 0}};
    CHECK(tension_at(s, 2).force == Approx(20 * (1 - 1 + 1)));
    CHECK(tension_at(s, 2).slope == Approx(10 * (1 - 2 + 3)));
    CHECK(tension_at(s, -1).force == -10);
    CHECK(tension_at(s, -1).slope == 10);
    CHECK(largest_slope(s) == Approx(20));
    // Its energy is the integral of its tension, by Simpson's rule on a polynomial of order 3: exact.
    const double work =
        2.0 / 6 * (tension_at(s, 0).force + 4 * tension_at(s, 1).force + tension_at(s, 2).force);
    CHECK(elastic_energy(s, 2) == Approx(work).epsilon(1e-14));
    CHECK(elastic_energy(s, -1) == 5);
}

TEST_CASE("a relaxing spring held at a length bears k e + k1 e exp(-t/tau)", "[unit]") {
    Body body = relaxing_oscillator();
    SpringSystem system(body.network, nullptr);
    CHECK(system.tension(0, 1.1).force == Approx(0.1 * kStiffness));  // no arm is put on
    system.put_on_arms(body.x);
    CHECK(system.tension(0, 1.1).force == Approx(0.1 * (kStiffness + kArm)));
    CHECK(system.tension(0, 1.1).slope == kStiffness + kArm);
    std::vector<double> stretched(system.length());
    body.x[1].x += 0.1;
    system.packing().pack(body.x, stretched);
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) system.creep(stretched, kTime / kSteps);
    // 1/(1 + z + z^2/2) is exp(-z) to z^3/6: 1000 steps of z = 1e-3 are out by 1.7e-7.
    CHECK(system.tension(0, 1.1).force == Approx(0.1 * (kStiffness + kArm * std::exp(-1))).epsilon(2e-7));
    system.creep(stretched, 1e9);  // long steps do not overshoot
    CHECK(system.tension(0, 1.1).force == Approx(0.1 * kStiffness).epsilon(1e-12));
}

TEST_CASE("a mass on a standard linear solid swings as its characteristic roots say, to second order",
          "[unit]") {
    constexpr double kLong = 0.7;  // s, about one swing and a half
    const double exact = place_after(kLong);
    CHECK(place_after(0) == Approx(1).epsilon(1e-12));
    CHECK(std::abs(exact) > 0.01);
    for (const char* method : {"rk4", "tsit5", "verlet", "tr_bdf2"}) {
        INFO(method);
        const double coarse = std::abs(found_after(kLong, method, 400) - exact);
        const double fine = std::abs(found_after(kLong, method, 800) - exact);
        CHECK(fine < 2e-4);
        CHECK(std::log2(coarse / fine) == Approx(2).margin(0.1));
    }
}

TEST_CASE("a cycle of stretch loses what relaxes, and nothing else", "[unit]") {
    Body body = relaxing_oscillator();
    SpringSystem system(body.network, nullptr);
    body.x[1].x += 0.2;
    const Energy before = system.energy(body.x, body.v);
    Simulation plain(system, settings_of("rk4", 1e-3), 0.02, body.x, body.v);
    for (std::uint64_t i = 0; i < 100; ++i) plain.advance(i, 0.02 * static_cast<double>(i));
    const Energy after = system.energy(body.x, body.v);
    CHECK(after.total() < 0.05 * before.total());
    CHECK(plain.energy_gain() < 1e-12 * before.total());
}

TEST_CASE("a restored run of relaxing threads goes on with the same bits", "[unit]") {
    Body body = bodies::ragged_web(0);
    bodies::bend(body);
    body.network.fixed[0] = 1;
    for (const char* method : {"rk4", "tr_bdf2", "xpbd"}) {
        INFO(method);
        const SimulationSettings settings = settings_of(method, 2e-3);
        std::vector<double> memory(kSimulationMemory), creep(body.network.springs.size());
        auto x = body.x, v = body.v;
        SpringSystem system(body.network, nullptr);
        Simulation run(system, settings, 0.01, x, v, memory, creep);
        for (std::uint64_t i = 0; i < 3; ++i) run.advance(i, 0.01 * static_cast<double>(i));
        auto x2 = x, v2 = v;
        auto memory2 = memory, creep2 = creep;
        run.advance(3, 0.03);
        run.advance(4, 0.04);

        auto start_x = body.x, start_v = body.v;
        SpringSystem system2(body.network, nullptr);
        std::vector<double> memory3(kSimulationMemory), creep3(body.network.springs.size());
        Simulation restored(system2, settings, 0.01, start_x, start_v, memory3, creep3);
        std::copy(x2.begin(), x2.end(), start_x.begin());
        std::copy(v2.begin(), v2.end(), start_v.begin());
        memory3 = memory2;
        std::copy(creep2.begin(), creep2.end(), creep3.begin());
        restored.advance(3, 0.03);
        restored.advance(4, 0.04);
        CHECK(bodies::same_bits(x, start_x));
        CHECK(bodies::same_bits(v, start_v));
        CHECK(creep == creep3);
    }
}

TEST_CASE("a frame that is refused gives the dashpots back too", "[unit]") {
    Body body = relaxing_oscillator();
    std::vector<double> memory(kSimulationMemory), creep(1);
    SpringSystem system(body.network, nullptr);
    body.x[1].x += 0.2;
    Simulation run(system, settings_of("rk4", 1e-3), 0.02, body.x, body.v, memory, creep);
    run.advance(0, 0);
    const double before = creep[0];
    const std::vector<Vec3> wind(2, Vec3{NAN, 0, 0});
    system.set_surroundings({{}, 0, wind});
    CHECK_THROWS(run.advance(1, 0.02));
    CHECK(creep[0] == before);
    CHECK(before != Approx(0.2).epsilon(1e-3));
}

TEST_CASE("threads that relax have no tolerance, and curved ones no bound for every arrangement", "[unit]") {
    Body body = relaxing_oscillator();
    SpringSystem system(body.network, nullptr);
    SimulationSettings within = settings_of("tsit5", 0);
    within.tolerance = 1e-6;
    CHECK_THROWS_WITH(Simulation(system, within, 0.02, body.x, body.v), Catch::Contains("threads that relax"));
    CHECK(bound_step(system, *find_method("rk4")) ==
          Approx(std::sqrt(8 * kMass / (kStiffness + kArm))).epsilon(1e-5));
    body.network.springs[0].law = {0.5, 0.4, 0, 0};
    const SpringSystem curved(body.network, nullptr);
    CHECK(std::isinf(bound_step(curved, *find_method("rk4"))));
}

TEST_CASE("a load on a curved thread settles where its curve bears it", "[unit]") {
    Body body = bodies::oscillator(kMass, kStiffness);
    body.network.springs[0].law = {0.9, 0.3, kArm, kTime};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{9.81 * 4, 0, 0}, 0, {}});
    REQUIRE(settle(system, body.x).converged);
    CHECK(tension_at(body.network.springs[0], body.x[1].x - 1).force ==
          Approx(4 * 9.81 * kMass).epsilon(1e-12));
    CHECK(body.x[1].x - 1 > 4 * 9.81 * kMass / kStiffness);  // it has softened
}
