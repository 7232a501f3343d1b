#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "integrator.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// 200,000 particles of 1 ug in a net whose edge is fixed, 1 mm apart, threads strained by 2 %.
Body large_net() {
    constexpr std::uint32_t kRows = 400, kColumns = 500;
    constexpr double kMass = 1e-9, kSpacing = 1e-3, kStiffness = 0.1, kDamping = 1e-7;
    Body body;
    for (std::uint32_t row = 0; row < kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const bool edge = row == 0 || column == 0 || row + 1 == kRows || column + 1 == kColumns;
            const auto i = body.add({kSpacing * column, kSpacing * row, 0}, kMass, edge);
            if (column > 0) body.join(i - 1, i, kSpacing / 1.02, kStiffness, kDamping);
            if (row > 0) body.join(i - kColumns, i, kSpacing / 1.02, kStiffness, kDamping);
        }
    return body;
}

}  // namespace

TEST_CASE("a net of 200,000 particles moves by every method alike", "[extreme]") {
    const Body net = large_net();
    const std::vector<Vec3> wind(net.x.size(), Vec3{0, 0, 1e-8});
    constexpr int kSteps = 4;
    constexpr double kStep = 5e-5;  // s; Verlet's limit is 71 us
    // a/2 t^2 with a = 10 m/s^2, where all neighbors move alike; methods of order one are a step late or early.
    constexpr double kWay = 0.5 * 10 * (kSteps * kStep) * (kSteps * kStep);
    for (const MethodInfo& method : methods()) {
        INFO(method.name);
        Body body = net;
        SpringSystem system(body.network, nullptr);
        system.set_surroundings({{}, 0, wind});
        Integrator(system, method).advance(body.x, body.v, kStep, kSteps);
        const std::size_t middle = body.x.size() / 2 + 250;
        CHECK(body.x[middle].z == Approx(kWay).epsilon(method.order == 1 ? 1.0 / kSteps + 1e-6 : 1e-6));
        const auto finite = [](const Vec3& each) { return is_finite(each); };
        CHECK(std::all_of(body.x.begin(), body.x.end(), finite));
        CHECK(std::all_of(body.v.begin(), body.v.end(), finite));
    }
}

TEST_CASE("a simulation of 200,000 particles advises its step, runs and tells its error", "[extreme]") {
    Body body = large_net();
    const std::vector<Vec3> wind(body.x.size(), Vec3{0, 0, 1e-8});
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0, wind});
    constexpr double kFrame = 1e-3;  // s
    SimulationSettings settings;
    settings.method = find_method("verlet");
    Simulation run(system, settings, kFrame, body.x, body.v);
    // Neighbors all move against each other: along their line by k, across it by the tension over the length.
    constexpr double kAlong = 0.1, kAcross = 0.1 * (1 - 1 / 1.02), kMass = 1e-9;
    CHECK(run.advice().angular_frequency == Approx(std::sqrt(4 * (kAlong + kAcross) / kMass)).epsilon(2e-4));
    run.advance(0, 0);
    const std::size_t middle = body.x.size() / 2 + 250;
    CHECK(body.x[middle].z == Approx(0.5 * 10 * kFrame * kFrame).epsilon(1e-6));
    CHECK(run.error_estimate() < 1e-8);
}
