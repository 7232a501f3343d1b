#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kGravity = 9.81;
constexpr double kFrame = 0.01;
constexpr double kStep = 1e-4;

/// 1 kg that hangs at rest from springs of these stiffnesses, side by side, 1 m long at rest.
Body hanging_mass(const std::vector<double>& stiffnesses) {
    double sum = 0;
    for (const double each : stiffnesses) sum += each;
    Body body;
    body.add({0, 0, 0}, 1, true);
    body.add({0, -1 - kGravity / sum, 0}, 1);
    for (const double each : stiffnesses) body.join(0, 1, 1, each);
    return body;
}

using Change = void (*)(Network&);
void cut_last(Network& network) { network.springs.back().stiffness = 0; }
void remove_last(Network& network) { network.springs.pop_back(); }

/// Stands still for ten frames, loses its last spring, and goes on for `frames`.
void lose_spring(Body& body, const MethodInfo& method, Change change, int frames) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -kGravity, 0}, 0, {}});
    SimulationSettings settings;
    settings.method = &method;
    settings.step = kStep;
    settings.on_unstable = OnUnstable::as_asked;  // explicit Euler, undamped
    Simulation run(system, settings, kFrame, body.x, body.v);
    const double y = body.x[1].y;
    for (int i = 0; i < 10; ++i) run.advance(static_cast<std::uint64_t>(i), i * kFrame);
    CHECK(std::abs(body.x[1].y - y) < 1e-7);  // XPBD's springs take turns
    change(body.network);
    run.network_changed();
    for (int i = 10; i < 10 + frames; ++i) run.advance(static_cast<std::uint64_t>(i), i * kFrame);
}

}  // namespace

// First order errs by h/2 times the next derivative: h omega^2 t/2 of the amplitude, h g t/2 in free fall.
TEST_CASE("what a lost spring bore, the spring beside it bears", "[unit]") {
    const double rest = -1 - kGravity / 400, swing = kGravity / 400 - kGravity / 900, omega = 20;
    constexpr int kFrames = 30;
    const double y = rest + swing * std::cos(omega * kFrames * kFrame);
    for (const MethodInfo& method : methods()) {
        for (const Change change : {cut_last, remove_last}) {
            INFO(method.name);
            Body body = hanging_mass({400, 500});
            lose_spring(body, method, change, kFrames);
            const double first_order = kStep * omega * omega * kFrames * kFrame / 2 * swing;
            CHECK(std::abs(body.x[1].y - y) < (method.order == 1 ? 1.5 * first_order : 1e-5 * swing));
        }
    }
}

TEST_CASE("a mass on a thread that is cut falls freely", "[unit]") {
    constexpr double kTime = 0.2;
    const double fall = kGravity * kTime * kTime / 2;
    for (const MethodInfo& method : methods()) {
        for (const Change change : {cut_last, remove_last}) {
            INFO(method.name);
            Body body = hanging_mass({400});
            const double y = body.x[1].y - fall;
            lose_spring(body, method, change, 20);
            const double first_order = kStep * kGravity * kTime / 2;
            CHECK(std::abs(body.x[1].y - y) < (method.order == 1 ? 1.01 * first_order : 1e-9));
            // XPBD reads velocities off positions: rounding over h, step by step.
            CHECK(std::abs(body.v[1].y + kGravity * kTime) < 1e-8);
        }
    }
}
