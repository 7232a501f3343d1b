// The longest stable step of every method, found by running a chain 2 % below and 2 % above it. A chain of n
// beads of mass m on springs of stiffness k and damping c between fixed ends has along it the modes
//     omega_j = 2 sqrt(k/m) sin(j pi/(2 (n + 1))),    mu_j = c omega_j^2/k + k_d/m
// of q'' + mu q' + omega^2 q = 0, whose roots are lambda = -mu/2 +- sqrt(mu^2/4 - omega^2). Limits are those of
// the methods' stability functions (E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, IV.2),
// of Stoermer and Verlet's 2/omega, and of RKC's 2/3 (s^2 - 1)(1 - 2/15 2/13) in its most stages (Sommeijer,
// Shampine and Verwer 1998). Of SRKN 11 b they were worked out in 40 digits from its coefficients: where the
// one-step matrix has a trace of 2, and where drifts under drag, some of them backwards, no longer shrink
// velocities.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr std::size_t kBeads = 12;
constexpr double kSpacing = 0.01, kMass = 1e-6, kStiffness = 4;  // m, kg, N/m
constexpr double kEvery = std::numeric_limits<double>::infinity();

/// The chain of a row: damped by its springs and by drag.
struct Chain {
    double damping = 0;  ///< c, N s/m
    double drag = 0;     ///< k_d, N s/m
};

const double kOmega = 2 * std::sqrt(kStiffness / kMass) * std::sin(kBeads * bodies::kPi / (2 * (kBeads + 1)));
/// Springs whose damping leaves modes swinging: mu/omega^2 is c/k for all.
const Chain kSwinging{0.5 * kStiffness / kOmega, 0};
/// So much spring damping that the fastest root is real.
const Chain kOverdamped{100 * kStiffness / kOmega, 0};
/// Drag alone, far above the springs.
const Chain kDragged{0, 1e3 * kMass* kOmega};

double fastest_root(const Chain& chain) {
    const double mu = chain.damping * kOmega * kOmega / kStiffness + chain.drag / kMass;
    return mu / 2 + std::sqrt(mu * mu / 4 - kOmega * kOmega);
}

struct Limit {
    Chain chain;
    double step;  ///< s
};

/// By method; a new method needs its row.
std::map<std::string, std::vector<Limit>> limits() {
    const double damped = fastest_root(kOverdamped);
    const double most_stages = 2.0 / 3 * (250.0 * 250 - 1) * (1 - 4.0 / 195);
    const double mu = kOverdamped.damping * kOmega * kOmega / kStiffness;
    // h^2 omega^2 + 2 h mu = 4: what damping leaves of 2/omega where it is taken at the step's start.
    const double both = (std::sqrt(mu * mu + 4 * kOmega * kOmega) - mu) / (kOmega * kOmega);
    return {
        {"explicit_euler", {{kSwinging, kSwinging.damping / kStiffness}, {kOverdamped, 2 / damped}}},
        {"symplectic_euler", {{{}, 2 / kOmega}, {kOverdamped, both}}},
        {"verlet", {{{}, 2 / kOmega}}},
        {"rk4", {{{}, std::sqrt(8.0) / kOmega}, {kOverdamped, 2.7852935634 / damped}}},
        {"tsit5", {{kOverdamped, 3.5068469938 / damped}}},
        {"srkn6", {{{}, 9.0736094044 / kOmega}, {kDragged, 11.2058903815 * kMass / kDragged.drag}}},
        {"rkc2", {{kOverdamped, most_stages / damped}}},
        {"implicit_euler", {{{}, kEvery}, {kOverdamped, kEvery}}},
        {"tr_bdf2", {{{}, kEvery}}},
        {"provot", {{{}, 2 / kOmega}, {kOverdamped, both}}},
        {"xpbd", {{{}, kEvery}, {kDragged, kEvery}}},
    };
}

/// How many times larger than at first the chain's displacements are after many steps.
double growth(const MethodInfo& method, const Chain& chain, double step) {
    constexpr int kSteps = 4000, kStepsPerLook = 100;  // enough for 0.25 % a step to become e^10
    constexpr double kFirst = 1e-9;
    bodies::Body body = bodies::bead_string(kBeads, kSpacing, kMass, kStiffness, 0);
    for (Spring& s : body.network.springs) s.damping = chain.damping;
    const std::vector<Vec3> rest = body.x;
    for (std::size_t i = 1; i <= kBeads; ++i) body.x[i].x += (i % 2 == 0 ? kFirst : -kFirst) * kSpacing;
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, chain.drag, {}});
    Integrator integrator(system, method);
    double largest = 0;
    for (int done = 0; done < kSteps && largest < 1e6; done += kStepsPerLook) {
        integrator.advance(body.x, body.v, step, kStepsPerLook);
        largest = 0;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            if (!is_finite(body.x[i])) return kEvery;
            largest = std::max(largest, distance(body.x[i], rest[i]) / (kFirst * kSpacing));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("every method holds a chain at 0.98 of its limit, and explicit ones lose it at 1.02", "[unit]") {
    constexpr double kHeld = 10, kLost = 100;  // swings at 0.98 of 2/omega are up to 5 times the start
    const auto table = limits();
    for (const MethodInfo& method : methods()) {
        const std::string name(method.name);
        REQUIRE(table.count(name) == 1);
        for (const Limit& limit : table.at(name)) {
            INFO(name << " at " << limit.step << " s, c " << limit.chain.damping << ", k_d "
                      << limit.chain.drag);
            if (limit.step == kEvery) {
                CHECK(growth(method, limit.chain, 100 / kOmega) < kHeld);
                continue;
            }
            CHECK(growth(method, limit.chain, 0.98 * limit.step) < kHeld);
            CHECK(growth(method, limit.chain, 1.02 * limit.step) > kLost);
        }
    }
}
