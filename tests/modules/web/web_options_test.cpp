#include "web_options.hpp"

#include <catch2/catch.hpp>

#include "mass_spring/spring_system.hpp"
#include "measures.hpp"
#include "sample_webs.hpp"
#include "web_table.hpp"

using namespace orbweaver;
using namespace orbweaver::web;
using orbweaver::web::test::options_of;

namespace {

std::optional<Web> build(const std::string& table, Diagnostics& faults) {
    return build_web(options_of(table), web::test::kGravity, RandomStream(1, "web"), faults);
}

const std::string kAnchors = "anchors = [[0.3, 0, 0], [0, 0.3, 0], [-0.3, 0, 0], [0, -0.3, 0]]\n";

}  // namespace

TEST_CASE("the manifest's defaults are the thesis's values", "[unit]") {
    const Construction read = read_construction(options_of(kAnchors));
    const Construction thesis;
    CHECK(read.outer_frame.placement == thesis.outer_frame.placement);
    CHECK(read.outer_frame.rest_length == thesis.outer_frame.rest_length);
    CHECK(read.outer_frame.stiffness == thesis.outer_frame.stiffness);
    CHECK(read.inner_frame.placement == thesis.inner_frame.placement);
    CHECK(read.inner_frame.rest_length == thesis.inner_frame.rest_length);
    CHECK(read.inner_frame.stiffness == thesis.inner_frame.stiffness);
    CHECK(read.spokes.placement == thesis.spokes.placement);
    CHECK(read.spokes.rest_length == thesis.spokes.rest_length);
    CHECK(read.spokes.stiffness == thesis.spokes.stiffness);
    CHECK(read.move_outer == thesis.move_outer);
    CHECK(read.inward_pull == thesis.inward_pull);
    CHECK(read.hub_radius == thesis.hub_radius);
    CHECK(read.spiral_start == thesis.spiral_start);
    CHECK(read.spiral_end == thesis.spiral_end);
    CHECK(read.spiral_density == thesis.spiral_density);
    Diagnostics faults;
    const Silks silks = read_silks(options_of(kAnchors), faults);
    CHECK(faults.empty());
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(silks[k].tension == Approx(web::test::default_silks()[k].tension));
        CHECK(silks[k].axial_stiffness == Approx(web::test::default_silks()[k].axial_stiffness));
    }
}

TEST_CASE("a web is made of exactly one thing", "[unit]") {
    struct Case {
        const char* name;
        std::string table;
        std::string what;
    };
    const std::string strand = "strand = { from = [0, 0, 0], to = [1, 0, 0] }\n";
    const std::string network = "network = \"../networks/diamond.json\"\n";
    const std::vector<Case> cases = {
        {"nothing", "", "the web has nothing to be made of"},
        {"anchors and strand", kAnchors + strand, "the web has anchors and strand"},
        {"anchors and network", kAnchors + network, "the web has anchors and network"},
        {"all", kAnchors + network + strand, "the web has anchors and network and strand"},
        {"half a strand", "strand = { from = [0, 0, 0] }", "the strand has only one end"},
        {"two anchors", "anchors = [[0, 0, 0], [1, 0, 0]]", "the web has 2 anchors"},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        Diagnostics faults;
        CHECK_FALSE(build(c.table, faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].what == c.what);
        CHECK(faults[0].where.file == "scene.toml");
    }
}

TEST_CASE("each way to ask for a web gives one", "[unit]") {
    for (const std::string& table :
         {kAnchors, kAnchors + "prestress = \"over_extension\"", std::string("species = \"zilla_diodia\""),
          std::string("network = \"../networks/diamond.json\""),
          std::string("strand = { from = [0, 0, 0], to = [0.2, 0, 0] }")}) {
        INFO(table);
        Diagnostics faults;
        const auto web = build(table, faults);
        REQUIRE(web);
        CHECK(mass_spring::validate(web->network, web->layout.positions).empty());
        CHECK(mass_spring::count_parts(web->network) == 1);
    }
}

TEST_CASE("springs are damped as asked, else as suits the way the web is made taut", "[unit]") {
    const auto damping = [](const std::string& table) {
        Diagnostics faults;
        return build(kAnchors + table, faults)->network.springs.front().damping;
    };
    CHECK(damping("") == 1e-6);
    CHECK(damping("prestress = \"over_extension\"") == 0);
    CHECK(damping("damping = \"2e-7 N s/m\"") == 2e-7);
}

TEST_CASE("scales multiply what was built and leave its shape", "[unit]") {
    for (const std::string& table :
         {kAnchors, std::string("network = \"../networks/diamond.json\"\n"),
          std::string("strand = { from = [0, 0, 0], to = [0.2, 0, 0] }\ndamping = 1e-6\n")}) {
        INFO(table);
        Diagnostics faults;
        const auto plain = build(table, faults);
        const auto scaled = build(table + "stiffness_scale = 4\nmass_scale = 0.5\ndamping_scale = 8\n", faults);
        REQUIRE(plain);
        REQUIRE(scaled);
        CHECK(scaled->layout.positions == plain->layout.positions);
        for (std::size_t i = 0; i < plain->network.size(); ++i)
            CHECK(scaled->network.mass[i] == 0.5 * plain->network.mass[i]);
        for (std::size_t i = 0; i < plain->network.springs.size(); ++i) {
            CHECK(scaled->network.springs[i].rest_length == plain->network.springs[i].rest_length);
            CHECK(scaled->network.springs[i].stiffness == 4 * plain->network.springs[i].stiffness);
            CHECK(scaled->network.springs[i].damping == 8 * plain->network.springs[i].damping);
        }
    }
}

TEST_CASE("a web beyond the range of doubles is refused before it moves", "[extreme]") {
    Diagnostics faults;
    CHECK_FALSE(build(kAnchors + "axial_stiffness = { radius = 1e-314 }", faults));
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0].what, Catch::StartsWith("the web cannot be built: "));
}

TEST_CASE("a measured silk gives tension, stiffness and weight by its thickness", "[unit]") {
    Diagnostics faults;
    const std::string table = kAnchors + "silk = \"araneus_measured\"\n";
    const Silks silks = read_silks(options_of(table), faults);
    REQUIRE(faults.empty());
    const double area = 3.14159265358979 / 4 * 3e-6 * 3e-6;
    const Silk& radius = silks[2];
    CHECK(radius.axial_stiffness == Approx(10e9 * area));
    CHECK(radius.tension == Approx(40e6 * area));
    CHECK(radius.axial_stiffness / radius.tension == Approx(250));
    CHECK(radius.linear_density == Approx(1300 * area));

    // At rest: as heavy as its threads are long, within what its weight moves it.
    const auto web = build(table, faults);
    REQUIRE(web);
    double expected = 0;
    for (const Piece& piece : web->layout.pieces)
        expected += silks[static_cast<std::size_t>(piece.kind)].linear_density *
                    distance(web->layout.positions[piece.a], web->layout.positions[piece.b]);
    double found = 0;
    for (const double mass : web->network.mass) found += mass;
    CHECK(found == Approx(expected).epsilon(1e-4));
}

TEST_CASE("viscoelastic silk bears at breaking what it was measured to, and loses 65 % of a cycle", "[unit]") {
    Diagnostics faults;
    const Silks silks = read_silks(options_of(kAnchors + "silk = \"araneus_viscoelastic\"\n"), faults);
    REQUIRE(faults.empty());
    struct Measured {
        std::size_t kind;
        double diameter, modulus, breaking_strain, breaking_stress, cycle;
    };
    // Gosline and others 1999, table 1; the strains of cycles are those of assets/silks.
    for (const Measured& m : {Measured{2, 3e-6, 10e9, 0.27, 1.1e9, 0.2}, {4, 2.4e-6, 3e6, 2.7, 0.5e9, 1}}) {
        const double area = 3.14159265358979 / 4 * m.diameter * m.diameter;
        mass_spring::Network thread;
        thread.mass = {1, 1};
        thread.fixed = {1, 1};
        thread.springs = {
            mass_spring::Spring{0, 1, 1, silks[m.kind].axial_stiffness, 0, law_of(silks[m.kind], 1)}};
        CHECK(tension_at(thread.springs[0], 1e-9).slope / area == Approx(m.modulus).epsilon(1e-6));
        CHECK(tension_at(thread.springs[0], m.breaking_strain).force / area ==
              Approx(m.breaking_stress).epsilon(0.005));

        mass_spring::SpringSystem system(thread, nullptr);
        std::vector<Vec3> x{{}, {1, 0, 0}};
        system.put_on_arms(x);
        std::vector<double> packed(system.length());
        constexpr int kSteps = 3000;
        constexpr double kRise = 0.3;  // s
        double up = 0, back = 0, last = 0;
        for (int i = 1; i <= 2 * kSteps; ++i) {
            const double strain = m.cycle * (i <= kSteps ? i : 2 * kSteps - i) / kSteps;
            x[1].x = 1 + strain;
            system.packing().pack(x, packed);
            system.creep(packed, kRise / kSteps);
            const double force = system.tension(0, x[1].x).force;
            const double work = (force + last) / 2 * m.cycle / kSteps;
            if (i <= kSteps) up += work;
            if (i > kSteps && force > 0) back += work;  // then it hangs slack
            last = force;
        }
        CHECK(1 - back / up == Approx(0.65).margin(0.01));
    }
}

TEST_CASE("a web of viscoelastic silk is at rest where its threads bear what was sought", "[unit]") {
    Diagnostics faults;
    const auto web = build(kAnchors + "silk = \"araneus_viscoelastic\"\n", faults);
    REQUIRE(web);
    mass_spring::SpringSystem system(web->network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    system.put_on_arms(web->layout.positions);
    const auto& x = web->layout.positions;
    std::vector<Vec3> forces(x.size());
    system.forces(x, std::vector<Vec3>(x.size()), forces);
    CHECK(largest_residual(web->network, forces) < 1e-14);
    for (std::size_t i = 0; i < web->network.springs.size(); ++i) {
        if (web->layout.pieces[i].kind != Kind::spiral) continue;
        const mass_spring::Spring& spring = web->network.springs[i];
        CHECK(spring.law.arm == Approx(20 * spring.stiffness));
    }
}

TEST_CASE("a silk that would bear less when stretched more is refused", "[unit]") {
    Diagnostics faults;
    CHECK_FALSE(build(kAnchors + "material.radius = { softening = 3, stiffening = 3 }\n", faults));
    REQUIRE(faults.size() == 1);
    CHECK_THAT(to_string(faults.front()),
               Catch::Contains("the radius threads would bear less when stretched more; "
                               "expected material.radius.softening whose square is below "
                               "three times material.radius.stiffening"));
}

TEST_CASE("a silk of which something is missing is told, figure by figure", "[unit]") {
    Diagnostics faults;
    const auto web =
        build(kAnchors + "material.radius = { modulus = \"10 GPa\", diameter = \"3 um\" }\n", faults);
    CHECK_FALSE(web);
    REQUIRE(faults.size() == 18);
    CHECK_THAT(
        to_string(faults.front()),
        Catch::Contains("the web's silk has no material.anchor.modulus; expected modulus, density, diameter "
                        "and prestress of all five kinds of thread"));
}
