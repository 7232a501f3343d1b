#include "lost_vibrations.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("energy lost alike by a step and by half of it is an amplitude, and stands for the frames before it",
          "[unit]") {
    LostVibrations lost;
    lost.count_frame();
    lost.add(2, 1, 1e-9);  // as order one has it
    CHECK(lost.amplitude(1, 1) == 0);
    lost.count_frame();
    lost.add(1e-12, 1e-12, 1e-9);
    CHECK(lost.amplitude(1, 1) == 0);
    for (int i = 0; i < 3; ++i) lost.count_frame();
    lost.add(4, 4, 1e-9);
    CHECK(lost.energy() == 12);
    CHECK(lost.amplitude(6, 2) == 1);  // m omega^2 A^2/2
}

namespace {

/// A mass stretched by 1 mm on a spring, let go, followed for a frame in steps that are long for it.
struct LetGo {
    double error = 0;     ///< m, at most
    double estimate = 0;  ///< m
};

LetGo let_go(const char* method, double damping) {
    constexpr double kMass = 1e-6, kStiffness = 1e4, kStretch = 1e-3;  // 1e5 rad/s
    constexpr double kFrame = 0.02;
    Body body = bodies::oscillator(kMass, kStiffness, damping);
    body.x[1].x += kStretch;
    SpringSystem system(body.network, nullptr);
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = kFrame / 100;
    Simulation run(system, settings, kFrame, body.x, body.v);
    run.advance(0, 0);
    const double amplitude = kStretch * std::exp(-damping / (2 * kMass) * kFrame);
    return {std::abs(body.x[1].x - 1) + amplitude, run.error_estimate()};
}

}  // namespace

TEST_CASE("a vibration that steps are too long for is damped out, and the estimate tells its size", "[unit]") {
    for (const char* method : {"implicit_euler", "tr_bdf2"}) {
        INFO(method);
        const LetGo undamped = let_go(method, 0);
        CHECK(undamped.error == Approx(1e-3).epsilon(1e-3));
        CHECK(undamped.estimate > undamped.error / 2);
        CHECK(undamped.estimate < 3 * undamped.error);
    }
}
