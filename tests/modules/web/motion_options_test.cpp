#include "motion_options.hpp"

#include <catch2/catch.hpp>

#include "web_table.hpp"

using namespace orbweaver;
using namespace orbweaver::web;
using orbweaver::web::test::options_of;

TEST_CASE("a web moves as its table says", "[unit]") {
    Diagnostics faults;
    const auto plain = read_motion(options_of(""), faults).settings;
    CHECK(plain.method->name == "rk4");
    CHECK(plain.step == 0);
    CHECK(plain.tolerance == 0);
    CHECK(plain.on_unstable == mass_spring::OnUnstable::substep);
    const auto asked = read_motion(options_of("method = \"tsit5\"\ntolerance = \"1e-3 mm\"\nstep = \"2 ms\"\n"
                                              "on_unstable = \"stop\"\nmax_substeps = 7\n"),
                                   faults)
                           .settings;
    CHECK(asked.method->name == "tsit5");
    CHECK(asked.tolerance == Approx(1e-6));
    CHECK(asked.step == Approx(2e-3));
    CHECK(asked.on_unstable == mass_spring::OnUnstable::stop);
    CHECK(asked.max_substeps == 7);
    CHECK(faults.empty());
}

TEST_CASE("the manifest offers the methods there are", "[unit]") {
    for (const auto& method : mass_spring::methods()) {
        Diagnostics faults;
        const auto motion = read_motion(options_of("method = \"" + std::string(method.name) + "\"\n"), faults);
        CHECK(motion.settings.method == &method);
    }
}

TEST_CASE("a tolerance that the method cannot keep is a fault of the scene", "[unit]") {
    Diagnostics faults;
    read_motion(options_of("method = \"rk4\"\ntolerance = 1e-6\n"), faults);
    REQUIRE(faults.size() == 1);
    CHECK(to_string(faults.front()) ==
          "scene.toml:2:13: method rk4 does not tell the error of its steps; expected a tolerance with one of "
          "tsit5, rkc2, tr_bdf2, or with auto; choose another method, or say its step instead");
}

TEST_CASE("damped springs that the method does not take are a fault where the scene names it", "[unit]") {
    const auto faults_of = [](const std::string& table, double damping) {
        mass_spring::Network network;
        network.mass = {1, 1};
        network.fixed = {0, 0};
        network.springs = {{0, 1, 1, 1, damping}};
        Diagnostics faults;
        const Options options = options_of(table);
        check_damping(options, read_motion(options, faults), network, faults);
        return faults;
    };
    const Diagnostics faults = faults_of("drag = 0\nmethod = \"srkn6\"\n", 1e-6);
    REQUIRE(faults.size() == 1);
    CHECK(to_string(faults.front()) ==
          "scene.toml:2:10: springs are damped, which method srkn6 does not take; expected springs without "
          "damping, or another method, as tsit5; set their damping to 0 and let drag damp, or choose another "
          "method");
    CHECK(faults_of("method = \"srkn6\"\n", 0).empty());
    CHECK(faults_of("method = \"tsit5\"\n", 1e-6).empty());
    CHECK(faults_of("method = \"auto\"\ntolerance = 1e-4\n", 1e-6).empty());
}

TEST_CASE("an automatic choice has one goal", "[unit]") {
    Diagnostics faults;
    const Motion accurate = read_motion(options_of("method = \"auto\"\ntolerance = \"0.1 mm\"\n"), faults);
    CHECK(accurate.settings.method == nullptr);
    CHECK(accurate.tolerance == Approx(1e-4));
    CHECK(accurate.settings.tolerance == 0);
    const Motion cheap = read_motion(options_of("method = \"auto\"\nbudget = \"4 ms\"\n"), faults);
    CHECK(cheap.budget == Approx(4e-3));
    CHECK(faults.empty());
    read_motion(options_of("method = \"auto\"\n"), faults);
    read_motion(options_of("method = \"auto\"\nbudget = 1\ntolerance = 1\n"), faults);
    REQUIRE(faults.size() == 2);
    CHECK_THAT(to_string(faults[0]),
               Catch::StartsWith("scene.toml:1:10: method auto has no goal; expected either"));
    CHECK_THAT(to_string(faults[1]), Catch::StartsWith("scene.toml:1:10: method auto has two goals; expected"));
}

TEST_CASE("steps and budgets that nothing would heed are refused", "[unit]") {
    Diagnostics faults;
    read_motion(options_of("method = \"auto\"\ntolerance = \"0.1 mm\"\nstep = 1e-3\n"), faults);
    read_motion(options_of("method = \"rk4\"\nbudget = \"4 ms\"\n"), faults);
    REQUIRE(faults.size() == 2);
    CHECK_THAT(
        to_string(faults[0]),
        Catch::StartsWith("scene.toml:3:8: method auto is told a step, which it chooses itself; expected"));
    CHECK_THAT(to_string(faults[1]),
               Catch::StartsWith("scene.toml:2:10: method rk4 is given a budget, by which only auto chooses"));
}
