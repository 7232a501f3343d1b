#include "study/stability_files.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

StabilityResult sample() {
    StabilityResult result;
    result.scene = "a <web>";
    result.table = "web";
    result.duration_s = 0.5;
    result.axes.x = {"web.step", "web", "step", "s", {0.001, 0.002, 0.004}, true, std::nullopt};
    result.axes.y = {"web.drag", "web", "drag", "N s/m", {0, 1}, false, 0.5};
    result.axes.step_axis = 0;
    result.maps = {{"rk4",
                    {CellClass::stable, CellClass::degraded, CellClass::diverged, CellClass::stable,
                     CellClass::refused, CellClass::unknown},
                    {0.0015, std::numeric_limits<double>::infinity()},
                    0.002}};
    result.sentences = {"rk4: 2 stable"};
    return result;
}

}  // namespace

TEST_CASE("the CSV names its axes by the options' paths and has a row a cell", "[unit]") {
    CHECK(stability_csv(sample()) ==
          "method,web.step,web.drag,class\n"
          "rk4,0.001,0,stable\nrk4,0.002,0,degraded\nrk4,0.004,0,diverged\n"
          "rk4,0.001,1,stable\nrk4,0.002,1,refused\nrk4,0.004,1,unknown\n");
}

TEST_CASE("the JSON has axes, classes and advice", "[unit]") {
    const auto json = nlohmann::json::parse(stability_json(sample()));
    CHECK(json["axes"][0]["path"] == "web.step");
    CHECK(json["axes"][0]["scene"].is_null());
    CHECK(json["axes"][1]["scene"] == 0.5);
    CHECK(json["maps"][0]["classes"][1] == "degraded");
    CHECK(json["maps"][0]["advised_step_s"][0] == 0.0015);
    CHECK(json["maps"][0]["advised_step_s"][1].is_null());
    CHECK(json["maps"][0]["scene_step_s"] == 0.002);
}

TEST_CASE("the picture has a cell a run, the advised limit and the scene's own point", "[unit]") {
    const std::string svg = stability_svg(sample());
    for (const char* text : {"#56b4e9", "#d55e00", "advised limit", "the scene as it is", "web.step / s",
                             "web.drag / N s/m", "a &lt;web&gt;, rk4"}) {
        CAPTURE(text);
        CHECK_THAT(svg, Catch::Contains(text));
    }
    CHECK_THAT(svg, !Catch::Contains("nan"));
    CHECK_THAT(svg, !Catch::Contains("inf"));
    const std::string page = stability_page(sample());
    for (const char* outside : {"src=", "href=", "@import", "url("})
        CHECK_THAT(page, !Catch::Contains(outside));
}
