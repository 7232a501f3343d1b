#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "orbweaver/fault.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

Body small_thread() { return bodies::bead_string(8, 0.01, 1e-6, 0.01, 1e-5); }

/// Runs 100 frames of 1/60 s under gravity and drag and says how it ended. The state must stay finite.
std::string outcome_of(Body body, const char* method, double step, OnUnstable policy) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 1e-6, {}});
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = step;
    settings.on_unstable = policy;
    std::string outcome = "done";
    try {
        Simulation run(system, settings, 1.0 / 60, body.x, body.v);
        for (std::uint64_t i = 0; i < 100; ++i) run.advance(i, static_cast<double>(i) / 60);
        outcome += " in " + std::to_string(run.steps());
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::diverged);
        outcome = fault.what();
    }
    for (std::size_t i = 0; i < body.x.size(); ++i) CHECK((is_finite(body.x[i]) && is_finite(body.v[i])));
    return outcome;
}

}  // namespace

TEST_CASE("extreme constants are refused or substepped, never run into nonsense", "[extreme]") {
    struct Case {
        const char* name;
        Body body;
        const char* method;
        double step;
        OnUnstable policy;
        const char* outcome;
    };
    Body stiff = small_thread();
    for (Spring& s : stiff.network.springs) s.stiffness *= 1e12;
    Body light = small_thread();
    light.network.mass[4] = 1e-15;
    Body held = small_thread();
    for (auto& fixed : held.network.fixed) fixed = 1;
    Body loose = small_thread();
    for (auto& fixed : loose.network.fixed) fixed = 0;
    Body alone;
    alone.add({0, 0, 0}, 1e-3);
    const Body undamped = bodies::oscillator(1e9, 1e9);  // drag is lost beside such a mass

    const Case cases[] = {
        {"stiffness x 1e12", stiff, "rk4", 0, OnUnstable::substep,
         "a frame of 16.67 ms would take 1.29e+06 steps of 12.92 ns; expected at most 100000; lower "
         "stiffness, "
         "damping or drag, raise the masses, or raise max_substeps, first of all at spring 4"},
        {"stiffness x 1e12, as asked", stiff, "rk4", 1e-3, OnUnstable::as_asked,
         "the position of particle 1 left for more than a million times the extent at t = 1.961 ms (frame "
         "0, "
         "step 2 of 17, each 980.4 us); the state at t = 0 s is kept; the largest stable step of rk4 is 14.36 "
         "ns, "
         "set by a mode of 1.97e+08 rad/s with a damping rate of 1 /s, strongest in spring 4"},
        {"mass 1e-15", light, "rk4", 0, OnUnstable::substep,
         "a frame of 16.67 ms would take 6.649e+06 steps of 2.507 ns; expected at most 100000; lower "
         "stiffness, damping or drag, raise the masses, or raise max_substeps"},
        {"mass 1e-15, as asked", light, "symplectic_euler", 1e-3, OnUnstable::as_asked,
         "the position of particle 4 left for more than a million times the extent at t = 2.941 ms (frame "
         "0, "
         "step 3 of 17, each 980.4 us); the state at t = 0 s is kept; the largest stable step of "
         "symplectic_euler "
         "is 2 ns, set by a mode of 4.472e+06 rad/s with a damping rate of 1e+09 /s"},
        {"everything fixed", held, "rk4", 0, OnUnstable::stop, "done in 100"},
        {"nothing fixed", loose, "rk4", 0, OnUnstable::stop, "done in 200"},
        {"one particle alone", alone, "rk4", 0, OnUnstable::stop, "done in 100"},
        {"one particle alone, explicit Euler", alone, "explicit_euler", 0, OnUnstable::stop, "done in 100"},
        {"step 10 s", small_thread(), "rk4", 10, OnUnstable::substep, "done in 200"},
        {"step 10 s, stop", stiff, "rk4", 10, OnUnstable::stop,
         "the asked step of 16.67 ms is longer than the largest stable one of rk4, 14.36 ns, set by "
         "spring 4; "
         "ask for a shorter step, or for on_unstable = \"substep\""},
        {"step 1e-12 s", small_thread(), "rk4", 1e-12, OnUnstable::substep,
         "a frame of 16.67 ms would take 1.667e+10 steps of 0.001 ns; expected at most 100000; ask for a "
         "longer step"},
        {"undamped explicit Euler", undamped, "explicit_euler", 0, OnUnstable::substep,
         "no step of explicit_euler is stable on an oscillation of 1 rad/s that next to nothing damps, "
         "strongest in spring 0; choose symplectic_euler or rk4, or add drag and damping"},
    };
    for (const Case& each : cases) {
        INFO(each.name);
        CHECK(outcome_of(each.body, each.method, each.step, each.policy) == each.outcome);
    }
}

TEST_CASE("what a sweep over the springs leaves undone is redone at shorter steps, and the warning says so",
          "[unit]") {
    // A taut string of stiff links, let go: one sweep carries a correction a few links far.
    Body body = bodies::bead_string(40, 0.01, 1e-6, 1e3, 0.5);
    for (std::size_t i = 1; i + 1 < body.x.size(); ++i) body.x[i].y += 0.002;
    SpringSystem system(body.network, nullptr);
    std::vector<std::string> warnings;
    SimulationSettings settings;
    settings.method = find_method("xpbd");
    settings.step = 1e-3;
    settings.warn = [&](const std::string& sentence) { warnings.push_back(sentence); };
    Simulation run(system, settings, 1.0 / 60, body.x, body.v);
    for (std::uint64_t i = 0; i < 4; ++i) run.advance(i, static_cast<double>(i) / 60);
    REQUIRE(warnings.size() == 1);
    INFO(warnings[0]);
    CHECK(warnings[0].find("xpbd corrects each spring once a step, which left too much undone") !=
          std::string::npos);
    CHECK(warnings[0].find("on_unstable = \"as_asked\" keeps the steps") != std::string::npos);
    CHECK(run.substep() < 1e-3);
}
