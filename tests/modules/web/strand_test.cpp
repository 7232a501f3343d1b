#include "strand.hpp"

#include <catch2/catch.hpp>

#include "mass_spring/relax.hpp"
#include "mass_spring/spring_system.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

Web strand(double extension) {
    Diagnostics faults;
    const auto web = lay_single_strand({{-0.1, 0, 0}, {0.1, 0, 0}, 5e-3, extension, 0.01}, 1e-8, 0, faults);
    REQUIRE(web);
    return *web;
}

double sag(Web web) {
    mass_spring::SpringSystem system(web.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    REQUIRE(mass_spring::relax(system, web.layout.positions, 1e-12, 100'000).converged);
    double lowest = 0;
    for (const Vec3& p : web.layout.positions) lowest = std::min(lowest, p.y);
    return -lowest;
}

}  // namespace

TEST_CASE("a strand is laid at rest lengths or beyond them", "[unit]") {
    CHECK(mass_spring::tension(strand(0).network.springs[7], strand(0).layout.positions) ==
          Approx(0).margin(1e-18));
    // k (l - r) with r = l/2.33: section 5.1's 75 to 250 % over
    CHECK(mass_spring::tension(strand(1.33).network.springs[7], strand(1.33).layout.positions) ==
          Approx(0.01 * 5e-3 * (1 - 1 / 2.33)));
    CHECK(strand(0).network.size() == 41);
    CHECK(strand(0).network.fixed[0] + strand(0).network.fixed[1] == 2);
}

TEST_CASE("a strand laid beyond its rest lengths hangs as the parabola of its tension", "[unit]") {
    // s = w L^2/(8 T): 39 weights of 1e-8 kg on T = 0.01 N/m * 5 mm * (1 - 1/2.33)
    const double tension = 0.01 * 5e-3 * (1 - 1 / 2.33);
    const double load = 40 * 1e-8 * 9.81 / 0.2;
    CHECK(sag(strand(1.33)) == Approx(load * 0.04 / (8 * tension)).epsilon(0.01));
}

TEST_CASE("a strand laid at rest lengths sags visibly, one laid beyond hardly", "[unit]") {
    CHECK(sag(strand(0)) > 0.02);
    CHECK(sag(strand(1.33)) < 0.005);
}

TEST_CASE("a strand without length is refused in words", "[unit]") {
    Diagnostics faults;
    CHECK_FALSE(lay_single_strand({{1, 2, 3}, {1, 2, 3}, 5e-3, 0, 0.01}, 1e-8, 0, faults));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].what == "the strand's ends are 0 m apart");
    CHECK(faults[0].expected == "two different places");
}
