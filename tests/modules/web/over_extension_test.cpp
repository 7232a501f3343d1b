#include <catch2/catch.hpp>

#include "mass_spring/relax.hpp"
#include "mass_spring/settle.hpp"
#include "mass_spring/spring_system.hpp"
#include "measures.hpp"
#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

TEST_CASE("threads bear the tensions that the thesis's listed lengths and constants give", "[unit]") {
    Construction how;
    Layout layout = web::test::thesis_layout();
    const auto network = over_extend(layout, how, web::test::kMass, 0);
    for (std::size_t i = 0; i < network.springs.size(); ++i) {
        const double tension = mass_spring::tension(network.springs[i], layout.positions);
        switch (layout.pieces[i].kind) {
            case Kind::anchor:
                CHECK(tension == Approx(3e-6));
                break;  // 0.001 N/m (5 mm - 2 mm)
            case Kind::frame:
                CHECK(tension == Approx(5e-6));
                break;  // 0.001 N/m (20 mm - 15 mm)
            default:
                CHECK(tension == Approx(4e-5));
                break;  // 0.01 N/m (7 mm - 3 mm)
        }
    }
}

TEST_CASE("a spring as long as its placement has the listed constants", "[unit]") {
    Layout layout;
    add_particle(layout, {0, 0, 0}, true);
    add_particle(layout, {7e-3, 0, 0}, false);
    add_particle(layout, {21e-3, 0, 0}, false);
    layout.pieces = {{0, 1, Kind::radius}, {1, 2, Kind::spiral}};
    const auto network = over_extend(layout, {}, 2e-8, 1e-7);
    CHECK(network.springs[0].rest_length == Approx(3e-3));
    CHECK(network.springs[0].stiffness == Approx(0.01));
    CHECK(network.springs[1].rest_length == Approx(6e-3));  // two of them in series
    CHECK(network.springs[1].stiffness == Approx(0.005));
    CHECK(network.springs[1].damping == 1e-7);
    CHECK(network.mass == std::vector<double>(3, 2e-8));
    CHECK(network.fixed == std::vector<std::uint8_t>{1, 0, 0});
}

TEST_CASE("the thesis's constants as listed let the frame collapse inward", "[unit]") {
    Layout layout = web::test::thesis_layout();
    CHECK(layout.positions.size() == Approx(2000).epsilon(0.15));
    const auto network = over_extend(layout, {}, web::test::kMass, 0);
    const double before = frame_area(layout, layout.positions);
    mass_spring::SpringSystem system(network, nullptr);
    system.set_surroundings({web::test::kGravity, 1e-8, {}});
    const auto rest = mass_spring::relax(system, layout.positions, 1e-10, 50'000);
    CHECK(rest.converged);
    // The frame's 5e-6 N do not bear radii of 4e-5 N: less than a fifth of the area is left.
    CHECK(frame_area(layout, layout.positions) < 0.2 * before);
    CHECK(measure_threads(network, layout.positions).slack_springs > 100);
}

TEST_CASE("a web that draws together comes to rest, where energies differ by less than their rounding",
          "[unit]") {
    Layout layout = web::test::thesis_layout();
    const auto network = over_extend(layout, {}, web::test::kMass, 0);
    mass_spring::SpringSystem system(network, nullptr);
    system.set_surroundings({web::test::kGravity, 1e-8, {}});
    const auto rest = mass_spring::settle(system, layout.positions);
    CHECK(rest.converged);
    CHECK(rest.tolerance == 1e-12);
    CHECK(rest.residual <= rest.tolerance);
}
