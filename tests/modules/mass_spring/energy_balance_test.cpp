#include "energy_balance.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("a motion balances: gravity, springs and wind give no energy of their own", "[unit]") {
    for (const double drag : {0.0, 0.05}) {
        bodies::Body body = bodies::ragged_web(0);
        const std::vector<Vec3> wind(body.x.size(), Vec3{3, 1, -2});
        SpringSystem system(body.network, nullptr);
        system.set_surroundings({{0, -9.81, 0}, drag, wind});
        const auto x0 = body.x;
        const Energy before = system.energy(body.x, body.v);
        Integrator(system, *find_method("rk4")).advance(body.x, body.v, 1e-3, 200);
        const EnergyBalance balance = balance_energy(system, before, x0, body.x, body.v);
        CHECK(balance.holds());
        CHECK(balance.turnover > 1);
        if (drag == 0) CHECK(std::abs(balance.gain) < 1e-6 * balance.turnover);  // RK4's error
        if (drag > 0) CHECK(balance.gain < -1e-3 * balance.turnover);            // dissipated
    }
}

TEST_CASE("a motion that grows by itself does not balance", "[unit]") {
    bodies::Body body = bodies::oscillator(0.01, 25);  // omega = 50 rad/s: RK4 is stable up to 56.6 ms
    body.x[1].x += 1e-3;
    SpringSystem system(body.network, nullptr);
    const auto x0 = body.x;
    const Energy before = system.energy(body.x, body.v);
    Integrator(system, *find_method("rk4")).advance(body.x, body.v, 0.062, 30);
    CHECK_FALSE(balance_energy(system, before, x0, body.x, body.v).holds());
    body.v[1].x = 1e200;  // finite, but its energy is not
    CHECK_FALSE(balance_energy(system, before, x0, body.x, body.v).holds());
}

TEST_CASE("rounding of a large elastic energy is no motion", "[unit]") {
    const bodies::Body body = bodies::bead_string(50, 0.01, 1e-6, 1, 1e-3);
    SpringSystem system(body.network, nullptr);
    auto x1 = body.x;
    for (Vec3& x : x1) x.x *= 1 + 1e-13;
    CHECK(balance_energy(system, system.energy(body.x, body.v), body.x, x1, body.v).holds());
}
