#include "motion_options.hpp"

#include <catch2/catch.hpp>

#include "web_table.hpp"

using namespace orbweaver;
using namespace orbweaver::web;
using orbweaver::web::test::options_of;

TEST_CASE("a web moves as its table says", "[unit]") {
    Diagnostics faults;
    const auto plain = read_motion(options_of(""), faults);
    CHECK(plain.method->name == "rk4");
    CHECK(plain.step == 0);
    CHECK(plain.tolerance == 0);
    CHECK(plain.on_unstable == mass_spring::OnUnstable::substep);
    const auto asked = read_motion(options_of("method = \"tsit5\"\ntolerance = \"1e-3 mm\"\nstep = \"2 ms\"\n"
                                              "on_unstable = \"stop\"\nmax_substeps = 7\n"),
                                   faults);
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
        const auto settings =
            read_motion(options_of("method = \"" + std::string(method.name) + "\"\n"), faults);
        CHECK(settings.method == &method);
    }
}

TEST_CASE("a tolerance that the method cannot keep is a fault of the scene", "[unit]") {
    Diagnostics faults;
    read_motion(options_of("method = \"rk4\"\ntolerance = 1e-6\n"), faults);
    REQUIRE(faults.size() == 1);
    CHECK(to_string(faults.front()) ==
          "scene.toml:2:13: method rk4 does not tell the error of its steps; expected a tolerance with one of "
          "tsit5, rkc2, tr_bdf2; choose another method, or say its step instead");
}
