#include "measures.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

TEST_CASE("measures of a round web are those of its circles", "[unit]") {
    // 32 radii, rings at 4, 6 ... 20 mm of which the innermost is the hub's, rim at 22 mm
    const Layout layout = web::test::ideal_web(32, 10, 2e-3);
    const OrbMeasures orb = measure_orb(layout, layout.positions);
    CHECK(orb.radii == 32);
    CHECK(orb.spiral_turns == Approx(9));
    CHECK(orb.mesh_width == Approx(2e-3));
    CHECK(orb.asymmetry == Approx(0).margin(1e-12));
    CHECK(orb.capture_area == Approx(std::numbers::pi * (20e-3 * 20e-3 - 4e-3 * 4e-3)));
    // area of a regular polygon: n/2 R^2 sin(2 pi/n)
    CHECK(frame_area(layout, layout.positions) == Approx(16 * 22e-3 * 22e-3 * sin_degrees(360.0 / 32)));
}

TEST_CASE("a web that is longer below its hub is asymmetric", "[unit]") {
    Layout layout = web::test::ideal_web(32, 10, 2e-3);
    for (Vec3& p : layout.positions)
        if (p.y < 0) p.y *= 1.5;
    for (const Index i : layout.hub)
        layout.positions[i].y = std::max(layout.positions[i].y, -layout.positions[i].y);
    Vec3 hub;
    for (const Index i : layout.hub) hub += layout.positions[i] / 32;
    const double up = 20e-3 - hub.y;
    const double low = 30e-3 + hub.y;
    CHECK(measure_orb(layout, layout.positions).asymmetry == Approx((low - up) / (low + up)));
}

TEST_CASE("silk is measured as it is, and slack and strain against rest lengths", "[unit]") {
    mass_spring::Network network;
    network.mass = {1, 2, 3};
    network.fixed = {1, 0, 0};
    network.springs = {{0, 1, 2.0, 1, 0}, {1, 2, 5.0, 1, 0}};
    const std::vector<Vec3> x = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
    const ThreadMeasures threads = measure_threads(network, x);
    CHECK(threads.silk_length == 7);
    CHECK(threads.total_mass == 6);
    CHECK(threads.max_strain == 0.5);
    CHECK(threads.slack_springs == 1);
    CHECK(largest_residual(network, std::vector<Vec3>{{9, 0, 0}, {0, 1, 0}, {0, 0, 2}}) == 2);
}

TEST_CASE("a web without a spiral has radii and no capture area", "[unit]") {
    const Layout layout = web::test::ideal_web(8, 1, 0.02);
    const OrbMeasures orb = measure_orb(layout, layout.positions);
    CHECK(orb.radii == 8);
    CHECK(orb.spiral_turns == 0);
    CHECK(orb.capture_area == 0);
    CHECK(orb.mesh_width == 0);
}
