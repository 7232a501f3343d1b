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
    result.asked_step_s = 0.004;
    result.axes.x = {"web.step", "web", "step", "s", {0.001, 0.002, 0.004}, {}, true, std::nullopt, false};
    result.axes.y = {"web.drag", "web", "drag", "N s/m", {0, 1}, {}, false, 0.5};
    result.axes.step_axis = 0;
    result.maps = {{"rk4",
                    {CellClass::stable, CellClass::degraded, CellClass::diverged, CellClass::stable,
                     CellClass::refused, CellClass::unknown},
                    {0.0015, std::numeric_limits<double>::infinity()},
                    0.002,
                    {"", "", "", "", "too long, by half", ""}}};
    result.sentences = {"rk4: 2 stable"};
    return result;
}

StabilityResult labelled() {
    StabilityResult result = sample();
    result.axes.y = {"scene.gravity", "scene", "gravity", "m/s^2", {0, 1}, {"[0,-1,0]", "calm"}, false, 1.0};
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
    CHECK(json["maps"][0]["reasons"][1] == "");
    CHECK(json["maps"][0]["reasons"][4] == "too long, by half");
    CHECK(json["maps"][0]["advised_step_s"][0] == 0.0015);
    CHECK(json["maps"][0]["advised_step_s"][1].is_null());
    CHECK(json["maps"][0]["scene_step_s"] == 0.002);
    CHECK(json["asked_step_s"] == 0.004);
}

TEST_CASE("labels are quoted in the CSV where they hold a comma, and values in the JSON", "[unit]") {
    CHECK_THAT(stability_csv(labelled()), Catch::Contains("rk4,0.001,\"[0,-1,0]\",stable\n") &&
                                              Catch::Contains("rk4,0.004,calm,unknown\n"));
    const auto json = nlohmann::json::parse(stability_json(labelled()));
    CHECK(json["axes"][1]["values"] == nlohmann::json::parse("[[0, -1, 0], \"calm\"]"));
    CHECK(json["axes"][1]["scene"] == "calm");
}

TEST_CASE("labelled cells are named beside their axis, and have the scene's point where it belongs", "[unit]") {
    const std::string svg = stability_svg(labelled());
    for (const char* text :
         {">[0,-1,0]</text>", ">calm</text>", ">scene.gravity</text>", "scene takes: 2 ms"}) {
        CAPTURE(text);
        CHECK_THAT(svg, Catch::Contains(text));
    }
}

TEST_CASE("the scene's point is marked as it asks and as it is run, each with its own entry", "[unit]") {
    StabilityResult result = sample();
    std::string svg = stability_svg(result);
    CHECK_THAT(svg, Catch::Contains("scene asks for: 4 ms") && Catch::Contains("scene takes: 2 ms"));
    CHECK_THAT(svg, !Catch::Contains("off this map"));
    result.asked_step_s = 0.02;
    svg = stability_svg(result);
    CHECK_THAT(svg, Catch::Contains("scene asks for: 20 ms (off this map)"));
    result.maps[0].taken_step_s = std::nullopt;
    CHECK_THAT(stability_svg(result), Catch::Contains("scene takes: none, it is stopped"));
}

TEST_CASE("advice that leaves the map is cut off at its edge", "[unit]") {
    StabilityResult result = sample();
    result.axes.y = {"web.drag", "web", "drag", "N s/m", {1, 10, 100}, {}, true, 10.0};
    result.maps[0].cells.assign(9, CellClass::stable);
    result.maps[0].reasons.assign(9, "");
    // The step's axis ends at 0.707 ms: below it the line was drawn along the edge.
    result.maps[0].advised_s = {0.001, 1e-5, 1e-7};
    const std::string svg = stability_svg(result);
    const auto count = [&](const std::string& part) {
        std::size_t found = 0;
        for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++found;
        return found;
    };
    CHECK(count("stroke=\"#000000\" stroke-width=\"2.4\"") == 1);
}

TEST_CASE("the picture has a cell a run, the advised limit and the scene's own point", "[unit]") {
    const std::string svg = stability_svg(sample());
    for (const char* text : {"#56b4e9", "#d55e00", "adviser: longest stable step", "web.step / s",
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
