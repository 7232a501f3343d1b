#include "stability_limit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver::mass_spring;

namespace {

constexpr double kRootEight = 2.8284271247461903;  // |R(iy)| = 1 of RK4
constexpr double kRealReach = 2.7852935634052816;  // z^3/24 - z^2/6 + z/2 - 1 = 0
constexpr double kLimitAccuracy = 1e-6;            // bisection to 1e-9, rounding of 1e-14 in the matrix

const MethodInfo& method(const char* name) { return *find_method(name); }

}  // namespace

TEST_CASE("stability limits agree with theory", "[unit]") {
    struct Case {
        const char* name;
        const char* method;
        double omega, mu, limit;
    };
    const double both = (-3 + std::sqrt(9.0 + 4 * 49)) / 49;
    const Case cases[] = {
        {"2 sqrt(2)/omega", "rk4", 500, 0, kRootEight / 500},
        {"2.785/mu", "rk4", 0, 40, kRealReach / 40},
        {"2/omega", "symplectic_euler", 500, 0, 2.0 / 500},
        {"2/mu", "symplectic_euler", 0, 40, 2.0 / 40},
        {"h^2 omega^2 + 2 h mu = 4", "symplectic_euler", 7, 3, both},
        {"2/omega", "verlet", 500, 0, 2.0 / 500},
        {"2/mu", "verlet", 0, 40, 2.0 / 40},
        {"3.5068/mu", "tsit5", 0, 40, 3.506846993804929 / 40},
        {"3.1414/omega", "srkn6", 500, 0, 3.1414 / 500},
        {"11.2059/mu", "srkn6", 0, 40, 11.2058903815174 / 40},
        {"none undamped", "rkc2", 500, 0, 0},
        {"2/omega", "provot", 500, 0, 2.0 / 500},
        {"none undamped", "explicit_euler", 500, 0, 0},
        {"mu/omega^2 underdamped", "explicit_euler", 10, 2, 2.0 / 100},
        {"mu/omega^2 hardly damped", "explicit_euler", 10, 1e-2, 1e-2 / 100},
        {"4/(mu + sqrt(mu^2 - 4 omega^2)) overdamped", "explicit_euler", 3, 10, 4 / (10 + std::sqrt(64.0))},
        {"2/mu", "explicit_euler", 0, 40, 2.0 / 40},
    };
    for (const Case& each : cases) {
        INFO(each.method << ", " << each.name);
        CHECK(stability_limit(method(each.method), each.omega, each.mu) ==
              Approx(each.limit).epsilon(kLimitAccuracy).margin(0));
    }
    CHECK(std::isinf(stability_limit(method("rk4"), 0, 0)));
    for (const char* name : {"implicit_euler", "tr_bdf2"}) {
        for (const double mu : {0.0, 1e-3, 10.0, 1e6})
            CHECK(std::isinf(stability_limit(method(name), 500, mu)));
    }
    for (const double mu : {0.0, 1e-3, 10.0, 1e6}) {
        CHECK(std::isinf(stability_limit(method("xpbd"), 500, mu)));
        CHECK(std::isinf(stability_limit(method("xpbd"), 0, mu)));  // by drag
    }
}

TEST_CASE("a stabilised method goes by the spectral radius of the system", "[unit]") {
    const MethodInfo& rkc2 = method("rkc2");
    // beta(s) = 2/3 (s^2 - 1)(1 - 2/15 2/13) with its most stages, 250.
    const double reach = 2.0 / 3 * (250.0 * 250 - 1) * (1 - 4.0 / 195);
    CHECK(stability_limit(rkc2, 0, 40) == Approx(reach / 40).epsilon(0.02));
    // A slow mode of a stiff system is followed with as many stages as the stiff one asks.
    CHECK(stability_limit(rkc2, 0, 1, 1000) == Approx(reach).epsilon(0.02));
}
