// A body in the hub of an orb web of real silk, held by its radii alone: massless threads from a rigid rim.
// With N threads of length l, axial stiffness EA and tension T, whose rest length is r = l/(1 + T/EA),
//     across the web  k_z = N T/l,    in it, any way,  k_xy = N (EA/r + T/l)/2:
// each thread adds the tangent k n n^T + (T/l)(I - n n^T) of a taut spring, and the mean of n n^T over
// directions evenly around a circle is half the identity. Far across,
//     F = N (T s + EA s^3/2),  s = z/l,
// the first terms of F = N EA z (1/r - 1/sqrt(l^2 + z^2)). Silk: Gosline and others 1999; prestress: Mortimer
// and others 2016.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "settle.hpp"
#include "simulation.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr std::size_t kThreads = 33;
constexpr double kLength = 90e-3;                           // m
constexpr double kSection = bodies::kPi / 4 * 3e-6 * 3e-6;  // m^2, 3 um thick
constexpr double kAxialStiffness = 10e9 * kSection;         // N
constexpr double kTension = 40e6 * kSection;                // N
constexpr double kRestLength = kLength / (1 + kTension / kAxialStiffness);
constexpr double kMass = 100e-6;                           // kg
constexpr double kAcross = kThreads * kTension / kLength;  // N/m
constexpr double kWithin = kThreads * (kAxialStiffness / kRestLength + kTension / kLength) / 2;

bodies::Body hub() {
    bodies::Body body;
    body.add({0, 0, 0}, kMass);
    for (std::size_t i = 0; i < kThreads; ++i) {
        const double angle = 2 * bodies::kPi * static_cast<double>(i) / kThreads;
        const auto rim = body.add({kLength * std::cos(angle), kLength * std::sin(angle), 0}, kMass, true);
        body.join(0, rim, kRestLength, kAxialStiffness / kRestLength);
    }
    return body;
}

/// How far `load` (N) moves the hub, m along the load.
double displacement(const Vec3& load) {
    bodies::Body body = hub();
    std::vector<Vec3> loads(body.x.size());
    loads[0] = load;
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0, loads});
    REQUIRE(settle(system, body.x).converged);
    return dot(body.x[0], load) / norm(load);
}

/// Hz, of the hub let go at `from`: from the first rise through the middle to the eleventh.
double frequency(const Vec3& from, double expected) {
    constexpr int kPeriods = 10;
    bodies::Body body = hub();
    body.x[0] = from;
    SpringSystem system(body.network, nullptr);
    SimulationSettings settings;
    settings.method = find_method("rk4");
    const double frame = 1 / (50 * expected);  // s
    Simulation run(system, settings, frame, body.x, body.v);
    double first = 0, last = 0;
    for (std::uint64_t i = 0, rises = 0; rises <= kPeriods; ++i) {
        REQUIRE(i < 50 * (kPeriods + 3));
        const double before = dot(body.x[0], from), time = frame * static_cast<double>(i);
        run.advance(i, time);
        const double after = dot(body.x[0], from);
        if (before >= 0 || after < 0) continue;
        last = time + frame * before / (before - after);
        if (rises++ == 0) first = last;
    }
    return kPeriods / (last - first);
}

}  // namespace

TEST_CASE("a hub is as stiff as its threads across the web and in it", "[unit]") {
    // Loads that move it so little that the cubic term is 1e-4 of the linear one.
    CHECK(kAcross * displacement({0, 0, 1e-4 * kLength * kAcross}) ==
          Approx(1e-4 * kLength * kAcross).epsilon(0.005));
    for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6, -0.8, 0}}) {
        const double load = 1e-5 * kLength * kWithin;
        CHECK(kWithin * displacement(load * way) == Approx(load).epsilon(0.005));
    }
}

TEST_CASE("100 mg in a hub of real silk swing at 5.13 Hz across the web and at 57.5 Hz in it", "[unit]") {
    const auto hertz = [](double stiffness) { return std::sqrt(stiffness / kMass) / (2 * bodies::kPi); };
    const double across = frequency({0, 0, 1e-4 * kLength}, hertz(kAcross));
    const double within = frequency({1e-5 * kLength, 0, 0}, hertz(kWithin));
    CHECK(across == Approx(hertz(kAcross)).epsilon(0.005));
    CHECK(within == Approx(hertz(kWithin)).epsilon(0.005));
    CHECK(across == Approx(5.13).epsilon(0.005));  // reckoned with r = l (1 - T/EA); with ours it is 5.124
    CHECK(within == Approx(57.5).epsilon(0.005));
}

TEST_CASE("a hub of real silk stiffens: 1 mN moves it by 6.12 mm across the web, not by 9.65 mm", "[unit]") {
    constexpr double kLoad = 1e-3;  // N
    const double z = displacement({0, 0, kLoad});
    CHECK(z == Approx(6.12e-3).epsilon(0.01));
    const double s = z / kLength;
    CHECK(kThreads * (kTension * s + kAxialStiffness * s * s * s / 2) == Approx(kLoad).epsilon(0.01));
    CHECK(kLoad / kAcross == Approx(9.65e-3).epsilon(0.01));
}
