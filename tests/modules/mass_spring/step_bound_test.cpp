#include "step_bound.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "adviser.hpp"
#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

const MethodInfo& rk4() { return *find_method("rk4"); }

double bound_of(const bodies::Body& body, double drag = 0) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, drag, {}});
    return bound_step(system, rk4());
}

/// The same network with its particles somewhere else.
double advised_at(const bodies::Body& body, const std::vector<Vec3>& x) {
    SpringSystem system(body.network, nullptr);
    return advise(system, x, rk4()).stable_step;
}

}  // namespace

TEST_CASE("the bound of a lone spring is its limit", "[unit]") {
    CHECK(bound_of(bodies::oscillator(0.01, 25)) == Approx(2 * std::sqrt(2.0) / 50).epsilon(1e-5));
    // mu = 100 /s against omega = 1 rad/s.
    CHECK(bound_of(bodies::oscillator(0.01, 0.01, 1)) == Approx(2.785 / 100).epsilon(1e-3));
}

TEST_CASE("the bound of a thread is that of neighbors swinging against each other along it", "[unit]") {
    // 2 sqrt(k/m) cos(pi/(2 (n + 1))) for n masses between fixed ends.
    const auto body = bodies::bead_string(30, 0.01, 1e-6, 1, 1e-3);
    const double omega = 2 * std::sqrt(1 / 1e-6) * std::cos(bodies::kPi / 62);
    CHECK(bound_of(body) == Approx(2 * std::sqrt(2.0) / omega).epsilon(0.01));
    CHECK(bound_of(body) <= 2 * std::sqrt(2.0) / omega * (1 + 1e-6));
}

TEST_CASE("no arrangement without strong compression is stiffer than the bound", "[unit]") {
    const RandomStream random(11, "arrangements");
    for (const double damping : {0.0, 0.02}) {
        bodies::Body body = bodies::ragged_web(damping);
        for (Spring& s : body.network.springs) s.rest_length = 1e-6;  // stretched however they stand
        const double bound = bound_of(body);
        CHECK(bound > 0);
        CHECK(std::isfinite(bound));
        std::uint64_t n = 0;
        double least = advised_at(body, body.x);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<Vec3> x = body.x;
            const double flat = trial % 2 == 0 ? 1 : 1e-3;  // every other time nearly on one line
            for (Vec3& each : x) {
                each.x = random.uniform(n++, -1, 1);
                each.y = flat * random.uniform(n++, -1, 1);
                each.z = flat * random.uniform(n++, -1, 1);
            }
            least = std::min(least, advised_at(body, x));
        }
        CHECK(bound <= least * (1 + 1e-4));  // to the precision of the iteration that advises
        CHECK(bound >= 0.4 * least);         // and not idly small
    }
}

TEST_CASE("drag bounds the step, and nothing bounds what cannot move", "[unit]") {
    bodies::Body alone;
    alone.add({}, 0.5);
    CHECK(bound_of(alone, 50) == Approx(2.785 / 100).epsilon(1e-3));
    CHECK(std::isinf(bound_of(alone)));
    bodies::Body held = bodies::oscillator(1, 1, 1);
    held.network.fixed[1] = 1;
    CHECK(std::isinf(bound_of(held)));
    CHECK(bound_step(SpringSystem(bodies::oscillator(1, 1).network, nullptr), *find_method("explicit_euler")) ==
          0);
}
