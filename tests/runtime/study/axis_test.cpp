#include "study/axis.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

MapAxis resolved(const OscillatorScene& scene, const std::string& text) {
    const auto axis = parse_axis(text);
    REQUIRE(axis);
    const PlannedScene planned = plan_scene(scene.settings.run);
    return resolve_axis(*axis, planned.plan);
}

}  // namespace

TEST_CASE("values are spaced evenly, in the logarithm or not, and end where they should", "[unit]") {
    const auto log = spaced(1e-3, 10, 5, true);
    for (std::size_t i = 0; i < 5; ++i) CHECK(log[i] == Approx(std::pow(10, static_cast<double>(i) - 3)));
    CHECK(log.back() == 10);
    CHECK(spaced(-1, 1, 3, false) == std::vector<double>{-1, 0, 1});
}

TEST_CASE("an axis finds its option, in the option's unit", "[unit]") {
    const OscillatorScene scene("omega = 12");
    const MapAxis step = resolved(scene, "oscillator.step=1..20 ms:4");
    CHECK(step.unit == "s");
    CHECK(step.values.front() == 0.001);
    CHECK(step.values.back() == 0.02);
    CHECK(step.log);
    CHECK_FALSE(step.own);
    const MapAxis omega = resolved(scene, "oscillator.omega=1..3:3:lin");
    CHECK(omega.values == std::vector<double>{1, 2, 3});
    CHECK(omega.own == 12);
    CHECK_FALSE(resolved(scene, "oscillator.growth=0..3:3").log);
    CHECK(resolved(scene, "oscillator.0.omega=1..3:3").option == "omega");
    CHECK(resolved(scene, "scene.step=1e-3..1e-2:3").own == 0.01);
}

TEST_CASE("numbers may be listed, in any order and with one unit for all", "[unit]") {
    const OscillatorScene scene("omega = 12");
    const MapAxis step = resolved(scene, "oscillator.step=5,1,20 ms");
    CHECK(step.values == std::vector<double>{0.001, 0.005, 0.02});
    CHECK(step.log);
    CHECK_FALSE(step.labelled());
    CHECK(step.assignment(1) == "oscillator.step=0.005");
    CHECK_FALSE(resolved(scene, "oscillator.growth=0,1,10").log);
    CHECK(resolved(scene, "oscillator.omega=1,30").own == 12);
}

TEST_CASE("options of whole numbers take whole numbers", "[unit]") {
    const OscillatorScene scene;
    const MapAxis seed = resolved(scene, "scene.seed=1..4:9:lin");
    CHECK(seed.values == std::vector<double>{1, 2, 3, 4});
    CHECK(seed.own == 1);
    CHECK(seed.assignment(2) == "scene.seed=3");
    CHECK_THAT(fault_of([&] { resolved(scene, "scene.seed=1..1.2:3"); }),
               Catch::Contains("these come to one whole number"));
}

TEST_CASE("values that are no numbers are labels, as typed and in that order", "[unit]") {
    const OscillatorScene scene;
    const MapAxis axis = resolved(scene, "oscillator.on_unstable=stop,substep,as_asked");
    CHECK(axis.labelled());
    CHECK(axis.values == std::vector<double>{0, 1, 2});
    CHECK_FALSE(axis.log);
    CHECK(axis.assignment(0) == "oscillator.on_unstable=stop");
    CHECK(std::get<std::string>(*planned_value(axis, plan_scene(scene.settings.run).plan)) == "substep");
    CHECK(resolved(scene, "scene.gravity=[0,0,0],[0,-9.81,0]").text(1) == "[0,-9.81,0]");
}

TEST_CASE("an axis that the scene does not know is refused in words", "[extreme]") {
    const OscillatorScene scene;
    struct Case {
        const char* axis;
        const char* sentence;
    };
    const Case cases[] = {
        {"web.step=1..2:3",
         "--axis web.step: the scene has no [web] that is run; add one to the scene or by --set web.KEY=VALUE, "
         "or vary an option of oscillator or scene"},
        {"scene.duration_s=1,2",
         "[scene] has no option 'duration_s'; did you mean 'duration'? expected name, "},
        {"oscillator.color=1,2",
         "[oscillator] has no option 'color'; 'orbweaver modules oscillator' lists all"},
        {"oscillator.stifness=1..2:3", "did you mean 'stiffness'?"},
        {"oscillator.method=1..2:3",
         "--axis oscillator.method: 'method' is of type choice, which has no range; expected a list of values"},
        {"oscillator.step=1 m..2 m:3",
         "--axis oscillator.step: its values are not in the option's unit; expected s or plain numbers"},
        {"oscillator.step=1 ms,2 m", "its values are not in the option's unit"},
        {"oscillator.step=1,long", "'long' is no number; expected numbers of s"},
        {"oscillator.omega=1,nan", "'nan' is no number; expected numbers of 1/s"},
        {"oscillator.step=1 ms,0.001 s", "0.001 is listed twice; name different values"},
        {"oscillator.on_unstable=stop,stop", "stop is listed twice; name different values"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.axis);
        CHECK_THAT(fault_of([&] { resolved(scene, c.axis); }), Catch::Contains(c.sentence));
    }
}
