#include "lost_vibrations.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("energy lost alike by a step and by half of it is an amplitude, and stands for the frames before it",
          "[unit]") {
    LostVibrations lost;
    lost.count_frame(1, 1);
    lost.add({2, 1, 1}, {1, 1, 1});  // as order one has it
    CHECK(lost.amplitude() == 0);
    CHECK(lost.felt() == 0);
    for (int i = 0; i < 3; ++i) lost.count_frame(1, 1);
    lost.add({4, 2, 6}, {4, 2, 6});
    CHECK(lost.energy() == 12);
    CHECK(lost.amplitude() == 1);  // m omega^2 A^2/2
    lost.count_frame(1, 1);
    CHECK(lost.energy() == 16);
    CHECK(lost.amplitude() == Approx(std::sqrt(4.0 / 3)).epsilon(1e-12));
}

TEST_CASE("slower motion is off by the share that lost vibrations have of what moves, and by no more than all",
          "[unit]") {
    LostVibrations lost;
    lost.count_frame(8, 0.5);
    lost.add({2, 1, 1}, {2, 1, 1});
    CHECK(lost.felt() == 0.125);
    lost.count_frame(4, 0.25);
    CHECK(lost.felt() == 0.25);
    lost.count_frame(0, 0);
    lost.add({20, 1, 1}, {20, 1, 1});
    CHECK(lost.felt() == 0.5);
}

TEST_CASE("what a mode lost tells how fast it was, and how heavy", "[unit]") {
    // The second mode of three beads: the middle one rests.
    constexpr double kMass = 1e-3, kTension = 2, kSpacing = 0.1, kSpeed = 0.3;
    Body body = bodies::bead_string(3, kSpacing, kMass, 1e4, kTension);
    const SpringSystem system(body.network, nullptr);
    const Phase still = phase_of(system, body.x, body.v);
    body.v[1].y = kSpeed;
    body.v[3].y = -kSpeed;
    const double energy = kMass * kSpeed * kSpeed;
    const Loss loss = loss_between(body.network, phase_of(system, body.x, body.v), still, energy, 1, 1e6);
    CHECK(loss.energy == energy);
    CHECK(loss.omega == Approx(std::sqrt(2 * kTension / (kSpacing * kMass))).epsilon(1e-9));
    CHECK(loss.mass == Approx(2 * kMass).epsilon(1e-9));
    CHECK(loss_between(body.network, phase_of(system, body.x, body.v), still, energy, 1, 10).omega == 10);
}

namespace {

/// A mass stretched by 1 mm on a spring, let go, followed for a frame in steps that are long for it.
struct LetGo {
    double error = 0;     ///< m, at most
    double estimate = 0;  ///< m
    std::string how;
};

constexpr double kMass = 1e-6, kStiffness = 1e4, kStretch = 1e-3;  // 1e5 rad/s
constexpr double kFrame = 0.02;

LetGo let_go(const char* method, double step, double damping, double tolerance = 0) {
    Body body = bodies::oscillator(kMass, kStiffness, damping);
    body.x[1].x += kStretch;
    SpringSystem system(body.network, nullptr);
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = step;
    settings.tolerance = tolerance;
    Simulation run(system, settings, kFrame, body.x, body.v);
    run.advance(0, 0);
    const double amplitude = kStretch * std::exp(-damping / (2 * kMass) * kFrame);
    return {std::abs(body.x[1].x - 1) + amplitude, run.error_estimate(), run.error_method()};
}

}  // namespace

TEST_CASE("a vibration that steps are too long for is damped out, and the estimate tells its size", "[unit]") {
    constexpr double kHalves = 2 * kMass * 34.657359;  // N s/m: half the amplitude is left after the frame
    for (const double damping : {0.0, kHalves}) {
        for (const auto& [method, step] :
             {std::pair{"implicit_euler", 2e-4}, {"tr_bdf2", 2e-4}, {"rk4", 2.2e-5}}) {
            INFO(method << ", " << damping);
            const LetGo run = let_go(method, step, damping);
            CHECK(run.error >= 0.5 * kStretch);
            CHECK(run.estimate > run.error / 2);
            CHECK(run.estimate < 3 * kStretch);
            CHECK(run.how.find("damped out") != std::string::npos);
        }
    }
}

TEST_CASE("within a tolerance a vibration that no error shows is told too", "[unit]") {
    const LetGo run = let_go("tr_bdf2", 0, 0, 1e-2);
    CHECK(run.error == Approx(kStretch).epsilon(0.01));
    CHECK(run.estimate > run.error / 2);
}

TEST_CASE("of two vibrations the slower has the larger size for the same energy, and that is told", "[unit]") {
    // Two masses each on a spring of its own; only the softer one is stretched.
    constexpr double kSofter = 100;  // N/m: 1e4 rad/s
    Body body = bodies::oscillator(kMass, kStiffness);
    const auto slower = body.add({0, 1, 0}, kMass);
    body.join(0, slower, 1, kSofter);
    body.x[slower].y += kStretch;
    SpringSystem system(body.network, nullptr);
    SimulationSettings settings;
    settings.method = find_method("tr_bdf2");
    settings.step = kFrame;
    Simulation run(system, settings, kFrame, body.x, body.v);
    run.advance(0, 0);
    CHECK(run.error_estimate() > kStretch);
    CHECK(run.error_estimate() < 4 * kStretch);
}

namespace {

/// Two links of 0.1 m hung level from a fixed point, the outer stretched by 1 mm and soft: its vibration has
/// energy like the swing's own, and bends its way.
Body level_chain() {
    Body body;
    body.add({0, 0, 0}, kMass, true);
    body.add({0.1, 0, 0}, kMass);
    body.add({0.201, 0, 0}, kMass);
    body.join(0, 1, 0.1, 100);
    body.join(1, 2, 0.1, 1);
    return body;
}

struct Swing {
    std::vector<Vec3> x;
    double estimate = 0;
};

Swing swing(const char* method, double step, double duration) {
    constexpr double kSixtieth = 1.0 / 60;
    Body body = level_chain();
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, 0, -9.81}, 0, {}});
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = step;
    Simulation run(system, settings, kSixtieth, body.x, body.v);
    const int frames = static_cast<int>(std::lround(duration / kSixtieth));
    for (int i = 0; i < frames; ++i) run.advance(static_cast<std::uint64_t>(i), i * kSixtieth);
    return {body.x, run.error_estimate()};
}

}  // namespace

TEST_CASE("vibrations that are lost leave slower motion elsewhere, and the estimate says how far", "[unit]") {
    constexpr double kDuration = 0.5;
    const Swing exact = swing("rk4", 2e-6, kDuration), coarse = swing("tr_bdf2", 1.0 / 60, kDuration);
    double error = 0;
    for (std::size_t i = 0; i < exact.x.size(); ++i) error = std::max(error, distance(exact.x[i], coarse.x[i]));
    CHECK(error > 0.02);  // many times the stretch
    CHECK(coarse.estimate > error / 2);
    CHECK(coarse.estimate < 10 * error);
}
