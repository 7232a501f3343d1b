#include "study/map_axes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

MapAxes chosen(const OscillatorScene& scene, const std::vector<std::string>& texts) {
    std::vector<AxisText> asked;
    asked.reserve(texts.size());
    for (const std::string& text : texts) asked.push_back(*parse_axis(text));
    return choose_axes(scene.settings, Subject(scene.settings), asked, scene.deadline);
}

}  // namespace

TEST_CASE("steps of a map divide the frame, so that they are taken as asked", "[unit]") {
    const OscillatorScene scene;
    const MapAxes axes = chosen(scene, {"oscillator.stiffness=0.5..2:2", "oscillator.step=1 ms..10 ms:20:lin"});
    CHECK(axes.step_axis == 1);
    CHECK(axes.other().path == "oscillator.stiffness");
    for (const double step : axes.y.values)
        CHECK(0.01 / step == Approx(std::round(0.01 / step)).epsilon(1e-12));
    CHECK(axes.y.values.front() == Approx(0.001));
    CHECK(axes.y.values.back() == 0.01);
}

TEST_CASE("cells lie row by row, and share the physics that are not the step", "[unit]") {
    const OscillatorScene scene;
    const MapAxes axes = chosen(scene, {"oscillator.step=1 ms..10 ms:2", "oscillator.stiffness=1..2:2"});
    REQUIRE(axes.cells() == 4);
    CHECK(axes.column(1) == 1);
    CHECK(axes.row(1) == 0);
    CHECK(axes.column(2) == 0);
    CHECK(axes.row(2) == 1);
    CHECK(axes.step_of(1) == 0.01);
    CHECK(axes.step_of(2) == 0.001);
    CHECK(axes.physics(0) == axes.physics(1));
    CHECK(axes.physics(3) == std::vector<std::string>{"oscillator.stiffness=2"});
    CHECK(chosen(scene, {"oscillator.omega=1..2:2", "oscillator.stiffness=1..2:2"}).physics(3) ==
          std::vector<std::string>{"oscillator.omega=2", "oscillator.stiffness=2"});
}

TEST_CASE("an axis that is not given is the step, or else the module's own", "[unit]") {
    const OscillatorScene scene("omega = 1000");
    const auto paths = [&](const std::vector<std::string>& texts) {
        const MapAxes axes = chosen(scene, texts);
        return axes.x.path + " " + axes.y.path;
    };
    CHECK(paths({}) == "oscillator.step oscillator.stiffness");
    CHECK(paths({"oscillator.omega=1..2:2"}) == "oscillator.step oscillator.omega");
    CHECK(paths({"oscillator.step=1..9 ms:2"}) == "oscillator.step oscillator.stiffness");
    const MapAxes axes = chosen(scene, {});  // around rk4's stable 2.83 ms
    CHECK(axes.x.values.front() == Approx(2.83e-3 / 16).epsilon(0.02));
    CHECK(axes.x.values.back() == 0.01);
    CHECK(paths({"scene.step=5 ms,10 ms"}) == "scene.step oscillator.stiffness");
}

TEST_CASE("the steps of a map reach what the scene asks for, its frame when it names none", "[unit]") {
    // rk4 holds up to 28 us, and 32 times that is 0.9 ms.
    const auto highest = [](const std::string& options) {
        const OscillatorScene scene("omega = 1e5\n" + options);
        return chosen(scene, {}).x.values.back();
    };
    CHECK(highest("step = 0.0001") == Approx(9.05e-4).epsilon(0.05));
    CHECK(highest("step = 0.005") == Approx(0.005));
    CHECK(highest("") == Approx(0.01));
    const OscillatorScene fine("step = 0.002");
    const OscillatorScene none;
    CHECK(asked_step(Subject(fine.settings), plan_scene(fine.settings.run).plan) == 0.002);
    CHECK(asked_step(Subject(none.settings), plan_scene(none.settings.run).plan) == 0.01);
}

TEST_CASE("how a scene is integrated is none of its physics", "[unit]") {
    const OscillatorScene scene;
    const MapAxes axes =
        chosen(scene, {"oscillator.on_unstable=stop,substep", "oscillator.tolerance=1e-6,1e-5"});
    CHECK(axes.step_axis == -1);
    CHECK(axes.physics(0).empty());
    CHECK(axes.step_of(0) == 0);
    CHECK(chosen(scene, {"oscillator.delay=0,1e-3", "oscillator.tolerance=1e-6,1e-5"}).physics(3).empty());
}

TEST_CASE("a labelled axis knows which label is the scene's own", "[unit]") {
    const OscillatorScene scene("on_unstable = \"stop\"");
    const auto own = [&](const std::string& text) { return chosen(scene, {text}).y.own; };
    CHECK(own("oscillator.on_unstable=substep,stop") == 1);
    CHECK(own("scene.gravity=[0, -9.81, 0],[0, 0, 0]") == 0);
    CHECK_FALSE(own("oscillator.on_unstable=substep,as_asked"));
}

TEST_CASE("axes that cannot be mapped are refused in words", "[extreme]") {
    const OscillatorScene scene;
    CHECK_THAT(fault_of([&] { chosen(scene, {"oscillator.stiffness=-1..1:3"}); }),
               Catch::StartsWith("--axis oscillator.stiffness=-1: 'stiffness' is -1"));
    CHECK_THAT(fault_of([&] { chosen(scene, {"oscillator.step=1..2:3"}); }),
               Catch::Contains("these steps come to one step of 10 ms"));
    struct Case {
        std::vector<std::string> axes;
        const char* sentence;
    };
    const Case cases[] = {
        {{"scene.duration=1..2:3"}, "--axis scene.duration: it has no effect"},
        {{"scene.name=a,b"}, "--axis scene.name: it has no effect"},
        {{"oscillator.method=rk4,verlet"}, "--axis oscillator.method: every method has a map of its own"},
        {{"oscillator.budget=1..2 ms:2"}, "--axis oscillator.budget: it has no effect"},
        {{"oscillator.step=1..9 ms:3", "scene.step=1..9 ms:3"},
         "--axis oscillator.step: steps are taken as asked"},
        {{"oscillator.on_unstable=stop,start"},
         "--axis oscillator.on_unstable=start: 'on_unstable' is \"start\""},
        {{"oscillator.omega=0,1"}, "--axis oscillator.omega=0: 'omega' is 0; expected"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.sentence);
        CHECK_THAT(fault_of([&] { chosen(scene, c.axes); }), Catch::Contains(c.sentence));
    }
}
