#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "orbweaver/fault.hpp"
#include "simulation.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

const MethodInfo& srkn6() { return *find_method("srkn6"); }

/// A thread of unequal beads, bent far out of line, so that its motion is anything but linear.
bodies::Body bent_thread() {
    bodies::Body body = bodies::bead_string(7, 0.1, 1, 400, 10);
    for (std::size_t i = 1; i <= 7; ++i) {
        body.network.mass[i] = 0.5 + 0.3 * static_cast<double>(i);
        body.x[i] += {0, 0.02 * static_cast<double>(i * (8 - i)), 0.01 * static_cast<double>(i)};
    }
    return body;
}

bodies::Body run_thread(const MethodInfo& method, double drag, double duration, int steps) {
    bodies::Body body = bent_thread();
    const std::vector<Vec3> wind(body.x.size(), Vec3{0, 0, 2});
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, drag, wind});
    Integrator(system, method).advance(body.x, body.v, duration / steps, steps);
    return body;
}

double largest_difference(const bodies::Body& a, const bodies::Body& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.x.size(); ++i) largest = std::max(largest, distance(a.x[i], b.x[i]));
    return largest;
}

}  // namespace

TEST_CASE("kicks and drifts keep their order under drag, wind and unequal masses", "[unit]") {
    constexpr double kDrag = 1.5;  // N s/m: rates of 0.6 to 1.9 /s
    // Another method's, converged: tsit5 at a hundredth of the step errs by less than 1e-12 m.
    const bodies::Body exact = run_thread(*find_method("tsit5"), kDrag, 1, 20000);
    const double coarse = largest_difference(run_thread(srkn6(), kDrag, 1, 60), exact);
    const double fine = largest_difference(run_thread(srkn6(), kDrag, 1, 120), exact);
    CHECK(std::log2(coarse / fine) == Approx(6).margin(0.5));
    CHECK(fine < 1e-6);
}

TEST_CASE("what drag slows comes as far as v/gamma (1 - exp(-gamma t))", "[unit]") {
    bodies::Body body;
    body.add({0, 0, 0}, 2);
    body.v[0] = {3, -1, 0.5};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0.8, {}});
    Integrator(system, srkn6()).advance(body.x, body.v, 0.1, 30);
    constexpr double kRate = 0.4;
    const double left = std::exp(-kRate * 3), way = (1 - left) / kRate;
    // A drift of at most 0.036 s leaves out z^7/5040 of its series.
    CHECK(body.v[0].x == Approx(3 * left).epsilon(1e-14));
    CHECK(body.x[0].x == Approx(3 * way).epsilon(1e-14));
    CHECK(body.x[0].y == Approx(-way).epsilon(1e-14));
}

TEST_CASE("the energy of long undamped motion comes and goes, and does not drift", "[unit]") {
    bodies::Body body = bodies::oscillator(2, 50);  // 5 rad/s
    body.x[1] = {1.1, 0.2, 0};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    const double before = system.energy(body.x, body.v).total();
    Integrator integrator(system, srkn6());
    double early = 0, late = 0;  // the largest departures in the first and in the last tenth of 20,000 steps
    for (int i = 0; i < 20000; ++i) {
        integrator.advance(body.x, body.v, 0.2, 1);
        const double off = std::abs(system.energy(body.x, body.v).total() - before);
        if (i < 2000) early = std::max(early, off);
        if (i >= 18000) late = std::max(late, off);
    }
    CHECK(early > 1e-9 * before);  // far above rounding
    CHECK(early < 1e-2 * before);
    CHECK(late < 1.5 * early);
}

TEST_CASE("damped springs are refused in a sentence, and when they come later too", "[unit]") {
    bodies::Body body = bodies::oscillator(1, 9, 0.1);
    SpringSystem system(body.network, nullptr);
    SimulationSettings settings;
    settings.method = &srkn6();
    CHECK_THROWS_WITH(
        Simulation(system, settings, 0.01, body.x, body.v),
        "springs are damped, which srkn6 does not take: set their damping to 0 and let drag damp, or "
        "choose another method, as tsit5");
    body.network.springs[0].damping = 0;
    system.network_changed();
    Simulation run(system, settings, 0.01, body.x, body.v);
    run.advance(0, 0);
    body.network.springs[0].damping = 0.1;
    CHECK_THROWS_AS(run.network_changed(), Fault);
}

TEST_CASE("steps of a resonance are shortened before they feed on it", "[unit]") {
    // h omega = 3.1416 lies in the window where an undamped mode grows by 0.04 % a step: e^8 in these 19,000.
    bodies::Body body = bodies::oscillator(1e-6, 1);
    body.x[1].x = 1.001;
    SpringSystem system(body.network, nullptr);
    const double before = system.energy(body.x, body.v).total();
    SimulationSettings settings;
    settings.method = &srkn6();
    settings.step = 3.1416e-3;
    bool warned = false;
    settings.warn = [&](const std::string&) { warned = true; };
    Simulation run(system, settings, 10 * settings.step, body.x, body.v);
    CHECK(warned);
    CHECK(run.advice().stable_step == Approx(3.1414e-3).epsilon(1e-6));
    for (std::uint64_t i = 0; i < 1900; ++i) run.advance(i, 0.031416 * static_cast<double>(i));
    CHECK(system.energy(body.x, body.v).total() == Approx(before).epsilon(0.02));
}
