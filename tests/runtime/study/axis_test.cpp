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

TEST_CASE("an axis is a path, two ends and a count", "[unit]") {
    const auto axis = parse_axis("web.strand.stiffness=1e-5..0.1:16:lin");
    REQUIRE(axis);
    CHECK(axis->path == "web.strand.stiffness");
    CHECK(axis->low.value == 1e-5);
    CHECK(axis->high.value == 0.1);
    CHECK(axis->count == 16);
    CHECK(axis->log == false);
    CHECK(parse_axis("a.b=1..2:3")->log == std::nullopt);
    CHECK(parse_axis("a.b=1..2:3:log")->log == true);
    CHECK(parse_axis("a.b=-2..-1:3"));
}

TEST_CASE("what is no axis is none", "[extreme]") {
    for (const char* text :
         {"", "web.step", "web.step=1", "web.step=1..2", "step=1..2:3", "web.step=2..1:3", "web.step=1..1:3",
          "web.step=1..2:1", "web.step=1..2:201", "web.step=1..2:-3", "web.step=1..2:3:cubic",
          "web.step=0..2:3:log", "web.step=-1..2:3:log", "web.step=a..b:3", "web.step=1..1e999:3",
          "web.step=nan..2:3", "web.step=1 parsec..2 parsec:3", "web.step=1..2:3:lin:lin",
          "web.step=1..2:99999999999"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_axis(text));
    }
}

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

TEST_CASE("an axis that the scene does not know is refused in words", "[extreme]") {
    const OscillatorScene scene;
    struct Case {
        const char* axis;
        const char* sentence;
    };
    const Case cases[] = {
        {"web.step=1..2:3",
         "--axis web.step: the scene has no [web] that is run; expected an option of scene or oscillator"},
        {"oscillator.stifness=1..2:3", "did you mean stiffness?"},
        {"oscillator.method=1..2:3",
         "--axis oscillator.method: [oscillator] has no option 'method' that is a "
         "number; expected omega, amplitude"},
        {"oscillator.step=1 m..2 m:3",
         "--axis oscillator.step: its ends are not in the option's unit; expected s or plain numbers"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.axis);
        CHECK_THAT(fault_of([&] { resolved(scene, c.axis); }), Catch::Contains(c.sentence));
    }
}
