// Every method against motions that are known in closed form, in the situations where webs degenerate.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "integrator.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kStep = 2e-4;  // s
constexpr int kSteps = 1000;
constexpr double kTime = kStep * kSteps;
const Vec3 kGravity{0, -9.81, 0}, kWind{1e-6, 0, -2e-6};  // m/s^2, N on every particle
constexpr double kDrag = 3e-6;                            // N s/m

/// Of the way, at 5000 steps a second and rates of a few to a hundred a second.
double share_allowed(const MethodInfo& method) {
    return method.order >= 4 ? 1e-9 : method.order == 2 ? 1e-4 : 3e-2;
}

Body moved(Body body, const MethodInfo& method) {
    SpringSystem system(body.network, nullptr);
    const std::vector<Vec3> wind(body.x.size(), kWind);
    system.set_surroundings({kGravity, kDrag, wind});
    Integrator(system, method).advance(body.x, body.v, kStep, kSteps);
    return body;
}

/// From x at velocity v: m v' = m g + f - k_d v.
Vec3 falls_to(const Vec3& x, const Vec3& v, double mass) {
    const double rate = kDrag / mass;
    const Vec3 at_last = (mass * kGravity + kWind) / kDrag;
    return x + kTime * at_last + ((1 - std::exp(-rate * kTime)) / rate) * (v - at_last);
}

}  // namespace

TEST_CASE("a lone particle falls through drag and wind as the closed form says, by every method", "[unit]") {
    constexpr double kMass = 1e-6;
    for (const MethodInfo& method : methods()) {
        INFO(method.name);
        Body body;
        body.add({0.3, 0.2, 0.1}, kMass);
        body.v[0] = {0.5, 1, -0.2};
        const Vec3 expected = falls_to(body.x[0], body.v[0], kMass);
        const double way = distance(expected, body.x[0]);
        CHECK(distance(moved(body, method).x[0], expected) <= share_allowed(method) * way);
    }
}

TEST_CASE("where everything is fixed nothing moves by a bit, by every method", "[unit]") {
    for (const MethodInfo& method : methods()) {
        INFO(method.name);
        Body body = bodies::ragged_web(0.3);
        for (auto& each : body.network.fixed) each = 1;
        for (Vec3& each : body.v) each = {};
        const Body after = moved(body, method);
        CHECK(bodies::same_bits(after.x, body.x));
        CHECK(bodies::same_bits(after.v, body.v));
    }
}

TEST_CASE("where nothing is fixed the center of mass falls like a lone particle, by every method", "[unit]") {
    constexpr double kMass = 1e-6;  // of each particle: drag then acts on the center alone
    const auto center = [](const std::vector<Vec3>& each) {
        Vec3 sum;
        for (const Vec3& one : each) sum += one;
        return sum / static_cast<double>(each.size());
    };
    for (const MethodInfo& method : methods()) {
        INFO(method.name);
        Body body = bodies::bead_string(8, 0.01, kMass, 0.01, 1e-5);
        for (auto& each : body.network.fixed) each = 0;
        for (Spring& s : body.network.springs) s.damping = 1e-6;
        for (std::size_t i = 0; i < body.x.size(); ++i)
            body.v[i] = {0.01, 0.02 * static_cast<double>(i % 3), 0};
        const Vec3 expected = falls_to(center(body.x), center(body.v), kMass);
        const double way = distance(expected, center(body.x));
        CHECK(distance(center(moved(body, method).x), expected) <= share_allowed(method) * way);
    }
}

TEST_CASE(
    "on a spring of no rest length a mass swings through its end as the closed form says, by every method",
    "[unit]") {
    // Tension k l points at the end from everywhere: m x'' = m g + f - k x - k_d x', each axis on its own.
    // explicit Euler's limit is k_d/k = 0.3 ms.
    constexpr double kMass = 1e-6, kStiffness = 0.01;
    const double rate = kDrag / (2 * kMass), omega = std::sqrt(kStiffness / kMass - rate * rate);
    for (const MethodInfo& method : methods()) {
        INFO(method.name);
        Body body;
        body.add({0, 0, 0}, kMass, true);
        body.add({1e-3, 0, 0},
                 kMass);  // in line with the end, through which the motion goes but for wind and weight
        body.v[1] = {0.1, 0, 0};
        body.join(0, 1, 0, kStiffness);
        const Vec3 middle = (kMass * kGravity + kWind) / kStiffness;
        const Vec3 start = body.x[1] - middle;
        const Vec3 expected =
            middle + std::exp(-rate * kTime) * (std::cos(omega * kTime) * start +
                                                (std::sin(omega * kTime) / omega) * (body.v[1] + rate * start));
        const double amplitude = norm(start) + norm(body.v[1]) / omega;
        const double error = distance(moved(body, method).x[1], expected) / amplitude;
        // omega h = 0.02: of order one, methods are off by some of omega^2 h t/2 = 0.2.
        CHECK(error <= (method.order >= 4 ? 1e-6 : method.order == 2 ? 1e-3 : 0.2));
    }
}
