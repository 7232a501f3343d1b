#include "study/subject.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

TEST_CASE("a subject is the module of the scene that can be studied", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    CHECK(subject.table() == "oscillator");
    CHECK(subject.scene().name == "swing");
    CHECK(subject.methods() == std::vector<std::string>{"explicit", "verlet", "rk4", "adaptive"});
    CHECK(subject.by_tolerance("adaptive"));
    CHECK_FALSE(subject.by_tolerance("rk4"));
    CHECK(subject.least_tolerance() == 1e-13);
    CHECK(subject.overrides({"rk4", 0.001, 0}) == std::vector<std::string>{"oscillator.method=rk4",
                                                                           "oscillator.on_unstable=as_asked",
                                                                           "oscillator.step=0.001"});
    CHECK(subject.overrides({"adaptive", 0, 1e-6}).back() == "oscillator.tolerance=1e-06");
    CHECK(subject.rung("rk4", 4).step == 0.0025);
    CHECK(subject.rung_within("rk4", 0.004).step == Approx(0.01 / 3));
    CHECK(subject.rung_within("rk4", 0.01 / 3).step == Approx(0.01 / 3));
    CHECK(subject.rung_within("rk4", 7).step == 0.01);
    CHECK(subject.rung_within("adaptive", 7).tolerance == 1e-6);
}

TEST_CASE("a run is as long as usual unless all of the scene was asked for", "[unit]") {
    OscillatorScene scene;
    CHECK(Subject(scene.settings).duration(0.1) == 0.1);
    CHECK(Subject(scene.settings).duration(1) == 0.2);
    scene.settings.full_duration = true;
    CHECK(Subject(scene.settings).duration(0.1) == 0.2);
}

TEST_CASE("methods keep the manifest's order", "[unit]") {
    OscillatorScene scene;
    scene.settings.methods = {"rk4", "verlet"};
    CHECK(Subject(scene.settings).methods() == std::vector<std::string>{"verlet", "rk4"});
}

TEST_CASE("what cannot be studied is refused in words", "[extreme]") {
    OscillatorScene scene("colour = 3");
    const std::string path = scene.settings.run.scene_path;
    CHECK_THAT(fault_of([&] { Subject{scene.settings}; }), Catch::Contains("'colour'"));
    CHECK(kind_of_fault([&] { Subject{scene.settings}; }) == FaultKind::invalid);

    scene.folder.write("scene.toml", "[counter]\n");
    scene.settings.run.module_directories = {fixture("counter")};
    CHECK(fault_of([&] { Subject{scene.settings}; }) ==
          path +
              ": no module of this scene can be studied; expected a table whose module's manifest has [study], "
              "such as [web]");

    scene.folder.write("scene.toml", "[scene]\nduration = 0\n[oscillator]\n");
    scene.settings.run.module_directories = {fixture("oscillator")};
    CHECK(fault_of([&] { Subject{scene.settings}; }) ==
          path + ": it lasts 0 s, in which there is nothing to study; expected a duration above 0");

    scene.folder.write("scene.toml", "[oscillator]\n");
    scene.settings.run.module_directories = {fixture("oscillator")};
    scene.settings.table = "web";
    CHECK_THAT(fault_of([&] { Subject{scene.settings}; }),
               Catch::Contains("no [web] of this scene can be studied"));
    scene.settings.table = "oscillator";
    scene.settings.methods = {"rk5"};
    CHECK(fault_of([&] { Subject{scene.settings}; }) ==
          "--method rk5: [oscillator] has no such method to study; expected explicit, verlet, rk4 or adaptive; "
          "did you mean rk4?");
    scene.settings.methods.clear();
    scene.settings.references = {"rk4", "rk5"};
    CHECK_THAT(
        fault_of([&] { Subject{scene.settings}; }),
        Catch::StartsWith("--references rk5: [oscillator] has no such method to study; expected explicit"));
    scene.settings.references = {"adaptive", "explicit"};
    CHECK(Subject{scene.settings}.spec().references == scene.settings.references);
}

TEST_CASE("rungs and times are said as a person would", "[unit]") {
    CHECK(to_string(Rung{"rk4", 4e-4, 0}) == "rk4 at 400 us");
    CHECK(to_string(Rung{"tsit5", 0, 1e-6}) == "tsit5 at a tolerance of 1e-06 m");
    CHECK(seconds_text(1.5) == "1.5 s");
    CHECK(seconds_text(0.0125) == "12.5 ms");
    CHECK(seconds_text(2e-8) == "20 ns");
}
