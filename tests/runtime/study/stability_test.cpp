#include "study/stability.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// Fast enough to need short steps, and too small to be seen beside the slow oscillator.
const std::string kFast = "omega = 1000\namplitude = 1e-4\n";

StabilityResult studied(OscillatorScene& scene, const std::vector<std::string>& axes) {
    const Subject subject(scene.settings);
    std::vector<AxisText> parsed;
    parsed.reserve(axes.size());
    for (const std::string& axis : axes) parsed.push_back(*parse_axis(axis));
    return study_stability(scene.settings, subject, parsed, scene.deadline);
}

}  // namespace

TEST_CASE("the map of a method is stable below its limit, diverged above, with the advice between", "[unit]") {
    OscillatorScene scene(kFast);
    scene.settings.methods = {"verlet"};
    const StabilityResult result =
        studied(scene, {"oscillator.step=0.1 ms..10 ms:12", "oscillator.stiffness=0.13..13:5"});
    REQUIRE(result.axes.step_axis == 0);
    REQUIRE(result.maps.size() == 1);
    const StabilityMap& map = result.maps[0];
    const std::size_t columns = result.axes.x.values.size();
    REQUIRE(map.cells.size() == columns * 5);
    REQUIRE(map.advised_s.size() == 5);
    for (std::size_t j = 0; j < 5; ++j) {
        const double limit = 2 / (1000 * std::sqrt(result.axes.y.values[j]));  // s
        CHECK(map.advised_s[j] == Approx(limit));
        for (std::size_t i = 0; i < columns; ++i) {
            CAPTURE(result.axes.x.values[i], limit);
            CHECK(map.cells[j * columns + i] ==
                  (result.axes.x.values[i] < limit ? CellClass::stable : CellClass::diverged));
        }
    }
    CHECK(result.asked_step_s == 0.01);         // it names none, so its frame
    CHECK(*map.taken_step_s == Approx(0.001));  // half the stable 2/omega, at a stiffness of 1
}

TEST_CASE("a run that ends but moves otherwise is degraded", "[unit]") {
    // Explicit Euler grows by sqrt(1 + (omega h)^2) a step: by 21 in 20 steps of 10 ms, by 4 % in those of 0.1
    // ms.
    OscillatorScene scene("omega = 60");
    scene.settings.methods = {"explicit"};
    const StabilityResult result =
        studied(scene, {"oscillator.step=0.1 ms..10 ms:2", "oscillator.stiffness=0.99..1.01:2"});
    CHECK(result.maps[0].cells[0] == CellClass::stable);
    CHECK(result.maps[0].cells[1] == CellClass::degraded);
}

TEST_CASE("without axes the step and the module's own are mapped, for all methods that have a step", "[unit]") {
    OscillatorScene scene(kFast);
    const StabilityResult result = studied(scene, {});
    CHECK(result.axes.x.path == "oscillator.step");
    CHECK(result.axes.y.path == "oscillator.stiffness");
    REQUIRE(result.maps.size() == 3);
    CHECK(result.maps[2].method == "rk4");
    CHECK(result.sentences.size() == 3);
    CHECK_FALSE(result.maps[0].taken_step_s);  // of explicit Euler no step is stable: as it is, it is refused
}

TEST_CASE("two axes that are no step map what the physics do", "[unit]") {
    OscillatorScene scene;
    scene.settings.methods = {"adaptive"};
    const StabilityResult result = studied(scene, {"oscillator.omega=10..40:3", "oscillator.growth=0..10:3"});
    CHECK(result.axes.step_axis == -1);
    CHECK(result.maps[0].advised_s.empty());
    for (const CellClass kind : result.maps[0].cells) CHECK(kind == CellClass::stable);
}

TEST_CASE("what is done about unstable steps is an axis, and compared with the same physics", "[unit]") {
    OscillatorScene scene(kFast);  // verlet holds up to 2 ms
    scene.settings.methods = {"verlet"};
    const StabilityResult result =
        studied(scene, {"oscillator.step=1 ms,5 ms", "oscillator.on_unstable=stop,as_asked,substep"});
    CHECK(result.maps[0].cells == std::vector<CellClass>{CellClass::stable, CellClass::refused,  //
                                                         CellClass::stable, CellClass::diverged,
                                                         CellClass::stable, CellClass::stable});
    for (const double advised : result.maps[0].advised_s) CHECK(advised == Approx(0.002));
    CHECK(result.axes.y.own == 2);
    CHECK(result.maps[0].reasons[1] == "module 'oscillator' failed while attaching: the step is too long");
    CHECK(result.maps[0].reasons[3].empty());
}

TEST_CASE("why cells were refused is said once, whatever the numbers in it", "[unit]") {
    OscillatorScene scene("bystander = 101\nmethod = \"verlet\"");
    scene.settings.methods = {"explicit"};
    const StabilityResult result =
        studied(scene, {"oscillator.step=1 ms,2 ms", "oscillator.bystander=50,150,200"});
    CHECK(result.sentences ==
          std::vector<std::string>{"explicit: 2 stable, 4 refused of 6 cells",
                                   "explicit: refused in 4 cells, as at oscillator.step=0.001 and "
                                   "oscillator.bystander=150: module 'oscillator' failed while attaching: "
                                   "explicit takes no bystander beyond 100 m, and not 150 m"});
}

TEST_CASE("a scene that leaves its method open by a budget has maps as any other", "[unit]") {
    OscillatorScene in_file("budget = \"1 ms\""), on_line;
    on_line.settings.run.overrides.emplace_back("oscillator.budget=1e-3");
    for (OscillatorScene* scene : {&in_file, &on_line}) {
        scene->settings.methods = {"verlet"};
        const StabilityResult result = studied(*scene, {"oscillator.step=1 ms,2 ms", "oscillator.omega=10,20"});
        for (const CellClass kind : result.maps[0].cells) CHECK(kind == CellClass::stable);
    }
}

TEST_CASE("tolerances are mapped for the methods that have one", "[unit]") {
    OscillatorScene scene;
    const StabilityResult result =
        studied(scene, {"oscillator.tolerance=1e-8..1e-4:3", "oscillator.omega=10..40:2"});
    REQUIRE(result.maps.size() == 1);
    CHECK(result.maps[0].method == "adaptive");
    for (const CellClass kind : result.maps[0].cells) CHECK(kind == CellClass::stable);
}

TEST_CASE("the frame is an axis as any other", "[unit]") {
    OscillatorScene scene;
    scene.settings.methods = {"verlet"};
    const StabilityResult result = studied(scene, {"scene.step=5,10,20 ms", "oscillator.omega=10,20"});
    for (const CellClass kind : result.maps[0].cells) CHECK(kind == CellClass::stable);
    CHECK(result.axes.x.own == 0.01);
}

TEST_CASE("a scene that is stopped at the step it asks for takes none", "[unit]") {
    OscillatorScene scene(kFast + "on_unstable = \"stop\"\nstep = 0.005");
    scene.settings.methods = {"verlet"};
    const StabilityResult result = studied(scene, {"oscillator.step=1 ms,5 ms", "oscillator.stiffness=1,2"});
    CHECK(result.asked_step_s == 0.005);
    CHECK_FALSE(result.maps[0].taken_step_s);
}

TEST_CASE("a map of nothing is none", "[extreme]") {
    OscillatorScene scene(kFast);
    const Subject subject(scene.settings);
    const auto study = [&] {
        study_stability(scene.settings, subject, {}, deadline_in(1e-6, scene.interrupt));
    };
    CHECK(kind_of_fault(study) == FaultKind::limit);
    CHECK_THAT(fault_of(study), Catch::Contains("no cell was run in --time"));
}

TEST_CASE("cells that there is no time for are unknown, those of short steps first", "[extreme]") {
    OscillatorScene scene(kFast + "delay = 0.005");
    scene.settings.methods = {"verlet"};
    const Subject subject(scene.settings);
    const StabilityResult result = study_stability(
        scene.settings, subject,
        {*parse_axis("oscillator.step=0.1 ms..1 ms:10"), *parse_axis("oscillator.stiffness=0.5..1:2")},
        deadline_in(2, scene.interrupt));
    CHECK(result.maps[0].cells.front() == CellClass::unknown);
    CHECK_THAT(result.sentences[0], Catch::Contains("unknown"));
}

TEST_CASE("methods without a step cannot be mapped over one", "[extreme]") {
    OscillatorScene scene;
    scene.settings.methods = {"adaptive"};
    CHECK_THAT(fault_of([&] { studied(scene, {}); }),
               Catch::Contains("have no step or tolerance that an axis could vary"));
}
