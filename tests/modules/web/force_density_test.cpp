#include <catch2/catch.hpp>

#include "mass_spring/adviser.hpp"
#include "mass_spring/relax.hpp"
#include "mass_spring/spring_system.hpp"
#include "measures.hpp"
#include "orbweaver/fault.hpp"
#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;
using mass_spring::tension;

namespace {

std::vector<Vec3> forces_at_rest(const mass_spring::Network& network, std::span<const Vec3> x,
                                 const Vec3& gravity) {
    mass_spring::SpringSystem system(network, nullptr);
    system.set_surroundings({gravity, 0, {}});
    const std::vector<Vec3> rest(x.size());
    std::vector<Vec3> forces(x.size());
    system.forces(x, rest, forces);
    return forces;
}

/// Checks F(i+1) - F(i) = 2 f sin(pi/N) at every crossing, counted from the hub outwards: an ideal web's
/// pieces lie ring by ring from the rim inwards, N of a radius and then N of a ring.
void check_node_balance(const Layout& layout, const mass_spring::Network& network, std::size_t rings) {
    const std::size_t n = layout.spokes.size();
    const double twice_sine = 2 * sin_degrees(180.0 / static_cast<double>(n));
    for (std::size_t ring = 0; ring < rings; ++ring)
        for (std::size_t s = 0; s < n; ++s) {
            const auto at = [&](std::size_t piece) {
                return tension(network.springs[piece], layout.positions);
            };
            const double outer = at(2 * n * ring + s);
            const double inner = ring + 1 < rings ? at(2 * n * (ring + 1) + s) : 0;
            const double around = at(2 * n * ring + n + s);
            CHECK(outer - inner == Approx(around * twice_sine).epsilon(1e-4));
        }
}

}  // namespace

TEST_CASE("a form-found ideal web is in balance at every node", "[unit]") {
    Layout layout = web::test::ideal_web(33, 30, 3e-3);
    const auto network = find_form(layout, web::test::default_silks(), 1e-8, 0, {});
    check_node_balance(layout, network, 30);
}

TEST_CASE("an over-extended ideal web comes to rest in balance at every node", "[unit]") {
    Layout layout = web::test::ideal_web(16, 8, 7e-3);
    const auto network = over_extend(layout, {}, 1e-8, 0);
    mass_spring::SpringSystem system(network, nullptr);
    REQUIRE(mass_spring::relax(system, layout.positions, 1e-11, 100'000).converged);
    check_node_balance(layout, network, 8);
}

TEST_CASE("a form-found web starts exactly at rest, with no slack spring", "[unit]") {
    for (const double irregularity : {0.0, 0.3}) {
        Layout layout = web::test::thesis_layout(irregularity);
        const auto network =
            find_form(layout, web::test::default_silks(), web::test::kMass, 0, web::test::kGravity);
        CHECK(mass_spring::validate(network, layout.positions).empty());
        const auto forces = forces_at_rest(network, layout.positions, web::test::kGravity);
        CHECK(largest_residual(network, forces) < 1e-12);
        CHECK(measure_threads(network, layout.positions).slack_springs == 0);
    }
}

TEST_CASE("the anchors of a web at rest bear its whole weight", "[unit]") {
    Layout layout = web::test::thesis_layout(0.1);
    const auto network =
        find_form(layout, web::test::default_silks(), web::test::kMass, 0, web::test::kGravity);
    const auto forces = forces_at_rest(network, layout.positions, web::test::kGravity);
    Vec3 borne;
    for (std::size_t i = 0; i < forces.size(); ++i)
        if (network.fixed[i] != 0) borne += forces[i];
    const double weight = 9.81 * measure_threads(network, layout.positions).total_mass;
    CHECK(borne.y == Approx(-weight).epsilon(1e-3));
    CHECK(std::abs(borne.x) < 1e-3 * weight);
    CHECK(std::abs(borne.z) < 1e-3 * weight);
}

TEST_CASE("the frame of a form-found web curves inward", "[unit]") {
    Layout layout = web::test::thesis_layout();
    find_form(layout, web::test::default_silks(), web::test::kMass, 0, {});
    for (std::size_t s = 0; s < layout.corners.size(); ++s) {
        const std::size_t begin = layout.corners[s];
        const std::size_t end = s + 1 < layout.corners.size() ? layout.corners[s + 1] : layout.frame.size();
        const PlanePoint a = layout.plane.project(layout.positions[layout.frame[begin]]);
        const PlanePoint b = layout.plane.project(layout.positions[layout.frame[end % layout.frame.size()]]);
        const PlanePoint m = layout.plane.project(layout.positions[layout.frame[(begin + end) / 2]]);
        CHECK(turn(a, b, m) > 0);  // the center's side
    }
}

TEST_CASE("defaults leave RK4 steps of about 0.3 ms", "[unit]") {
    Layout layout = web::test::thesis_layout(0.1);
    const auto network =
        find_form(layout, web::test::default_silks(), web::test::kMass, 1e-6, web::test::kGravity);
    const mass_spring::SpringSystem system(network, nullptr);
    const auto advice = mass_spring::advise(system, layout.positions, *mass_spring::find_method("rk4"));
    CHECK(advice.stable_step > 2.5e-4);
    CHECK(advice.stable_step < 5e-4);
}

TEST_CASE("a loaded thread takes the polygon of its force densities", "[unit]") {
    // Two pieces of q = 2 N/m between supports 1 m apart: 4 q s = P in the middle.
    Layout layout;
    add_particle(layout, {0, 0, 0}, true);
    add_particle(layout, {0.3, 0.2, 0.1}, false);
    add_particle(layout, {1, 0, 0}, true);
    layout.pieces = {{0, 1, Kind::strand}, {2, 1, Kind::strand}};
    const std::vector<double> densities = {2, 2};
    const std::vector<Vec3> loads = {{}, {0, -0.4, 0}, {}};
    const auto x = solve_force_densities(layout, densities, loads);
    CHECK(distance(x[1], {0.5, -0.1, 0}) < 1e-14);
    CHECK(x[0] == layout.positions[0]);
}

TEST_CASE("threads that hang on nothing have no form", "[unit]") {
    Layout layout;
    add_particle(layout, {0, 0, 0}, false);
    add_particle(layout, {1, 0, 0}, false);
    layout.pieces = {{0, 1, Kind::strand}};
    const std::vector<double> densities = {1};
    CHECK_THROWS_WITH(
        solve_force_densities(layout, densities, std::vector<Vec3>(2)),
        "the web's form cannot be found: part of it hangs on no anchor, or its tensions are too far apart");
}
