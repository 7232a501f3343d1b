// From one maximum of a damped oscillator m q'' + d q' + k q = 0 to the next, q falls by the factor
//     e^-delta,  delta = 2 pi zeta/sqrt(1 - zeta^2),  zeta = d/(2 sqrt(k m))
// (S. Timoshenko, Vibration Problems in Engineering, section 14), d being the spring's damping or the drag.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kMass = 0.1, kStiffness = 40;  // kg, N/m: omega 20 rad/s
constexpr double kPull = 1e-3;                  // m

/// Every maximum of the mass's displacement in `seconds`, m; that of the parabola through the three samples
/// around it.
std::vector<double> maxima(double spring_damping, double drag, double seconds) {
    constexpr double kStep = 1e-3;  // s; a twentieth of a radian
    bodies::Body body = bodies::oscillator(kMass, kStiffness, spring_damping);
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, drag, {}});
    Integrator integrator(system, *find_method("rk4"));
    std::vector<double> found;
    double last = kPull, before = kPull;
    body.x[1].x += kPull;
    for (int i = 0; i < static_cast<int>(seconds / kStep); ++i) {
        integrator.advance(body.x, body.v, kStep, 1);
        const double now = body.x[1].x - 1;
        const double rise = last - before, bend = now - 2 * last + before;
        if (last > before && last >= now) found.push_back(last - std::pow(rise + bend / 2, 2) / (2 * bend));
        before = last;
        last = now;
    }
    return found;
}

}  // namespace

TEST_CASE("an oscillator's maxima fall by the logarithmic decrement", "[unit]") {
    for (const double zeta : {0.01, 0.1, 0.4}) {
        const double damping = 2 * zeta * std::sqrt(kStiffness * kMass);
        const double decrement = 2 * bodies::kPi * zeta / std::sqrt(1 - zeta * zeta);
        for (const bool by_drag : {false, true}) {
            INFO("zeta " << zeta << (by_drag ? " by drag" : " by the spring"));
            const auto q = maxima(by_drag ? 0 : damping, by_drag ? damping : 0, 1.6);
            REQUIRE(q.size() >= 3);
            CHECK(std::log(kPull / q[0]) == Approx(decrement).epsilon(1e-3));
            for (std::size_t i = 1; i < q.size(); ++i)
                CHECK(std::log(q[i - 1] / q[i]) == Approx(decrement).epsilon(1e-3));
        }
    }
}
