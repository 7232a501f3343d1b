#include "study/accuracy_files.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

AccuracyResult sample() {
    AccuracyResult result;
    result.scene = "a <web>";
    result.table = "web";
    result.duration_s = 1;
    result.frame_s = 0.5;
    result.conditioning = {{0, 0.5, 1}, {1e-10, 1e-8, 1e-5}, 0.5, 2, false, {"rk4", 0.002, 0}};
    result.twin = {0.01, 1e-4, 0.02, 0, 0.03};
    result.reference = {"rk4", 1e-5, 0};
    result.second = {"verlet", 1e-6, 0};
    result.uncertainty_m = 1e-9;
    result.rows = {
        {{"rk4", 0.001, 0}, 1e-4, 0.25, 1000, "done", Deviation{0.1, 1e-3, 0.5, 0, 0.2}, 2},
        {{"rk4", 0.0005, 0}, 1e-9, 0.5, 2000, "unresolved", Deviation{std::nan(""), 0, 0, 0, HUGE_VAL}},
        {{"tsit5", 0, 1e-6}, std::nullopt, 0.125, 7, "diverged", std::nullopt}};
    result.front = {0};
    result.sentences = {"within 1e-4 m: rk4 at 1 ms, 0.25 s"};
    return result;
}

}  // namespace

TEST_CASE("the CSV has its columns, and leaves empty what a row does not have", "[unit]") {
    CHECK(accuracy_csv(sample()) ==
          "method,step_s,tolerance,error_m,wall_s,steps,outcome\n"
          "rk4,0.001,,0.0001,0.25,1000,done\n"
          "rk4,0.0005,,1e-09,0.5,2000,unresolved\n"
          "tsit5,,1e-06,,0.125,7,diverged\n");
}

TEST_CASE("the statistics are a table of their own, the twin's first", "[unit]") {
    CHECK(statistics_csv(sample()) ==
          "method,step_s,tolerance,mean_energy_relative,mean_shape_m,spectrum_distance,frequency_relative,"
          "power_relative\n"
          "twin,0.002,,0.01,0.0001,0.02,0,0.03\n"
          "rk4,0.001,,0.1,0.001,0.5,0,0.2\n"
          "rk4,0.0005,,,0,0,0,\n");
    const std::string page = accuracy_page(sample());
    CHECK_THAT(page, Catch::Contains("from 500 ms to the end, beyond the horizon"));
    CHECK_THAT(page,
               Catch::Contains("<td>rk4</td><td>1 ms</td><td>1.0e-01</td><td>1.0e-03</td><td>5.0e-01</td>"));
    CHECK_THAT(page, Catch::Contains("<td>rk4</td><td>500 us</td><td>-</td><td>0.0e+00</td>"));
    CHECK_THAT(page, !Catch::Contains("nan") && !Catch::Contains("inf<"));
}

TEST_CASE("the JSON says how the reference was found and what each run came to", "[unit]") {
    const auto json = nlohmann::json::parse(accuracy_json(sample()));
    CHECK(json["conditioning"]["horizon_s"] == 0.5);
    CHECK(json["conditioning"]["whole_run"] == false);
    CHECK(json["conditioning"]["deviation_m"].size() == 3);
    CHECK(json["reference"]["method"] == "rk4");
    CHECK(json["reference"]["tolerance"].is_null());
    CHECK(json["reference"]["confirmed_by"]["method"] == "verlet");
    CHECK(json["reference"]["uncertainty_m"] == 1e-9);
    CHECK(json["rows"].size() == 3);
    CHECK(json["rows"][0]["statistics"]["mean_energy_relative"] == 0.1);
    CHECK(json["rows"][0]["statistics"]["mean_shape_m"] == 1e-3);
    CHECK(json["rows"][0]["statistics"]["spectrum_distance"] == 0.5);
    CHECK(json["rows"][1]["statistics"]["mean_energy_relative"].is_null());
    CHECK(json["rows"][0]["timed_runs"] == 2);
    CHECK(json["conditioning"]["run"]["step_s"] == 0.002);
    CHECK(json["conditioning"]["statistics"]["spectrum_distance"] == 0.02);
    CHECK(json["reference"]["statistics"]["from_s"] == 0.5);
    CHECK(json["rows"][2]["error_m"].is_null());
    CHECK(json["pareto"] == nlohmann::json::array({0}));
    CHECK(json["sentences"].back() == "within 1e-4 m: rk4 at 1 ms, 0.25 s");
}

TEST_CASE("the page is whole in itself and escapes what it is told", "[unit]") {
    const std::string page = accuracy_page(sample());
    CHECK_THAT(page, Catch::StartsWith("<!DOCTYPE html>"));
    CHECK_THAT(page, Catch::Contains("within 1e-4 m: rk4 at 1 ms, 0.25 s"));
    CHECK_THAT(page, Catch::Contains("a &lt;web&gt;"));
    CHECK_THAT(page, !Catch::Contains("<web>"));
    for (const char* outside : {"src=", "href=", "@import", "url("})
        CHECK_THAT(page, !Catch::Contains(outside));
    CHECK_THAT(page, Catch::Contains("<tr class=\"front\"><td>rk4</td><td>1 ms</td>"));
}

TEST_CASE("the picture has a mark a run, hollow where nothing is resolved", "[unit]") {
    const std::string svg = accuracy_svg(sample());
    CHECK_THAT(svg, Catch::StartsWith("<svg xmlns"));
    CHECK_THAT(svg, Catch::Contains("run time / s"));
    CHECK_THAT(svg, Catch::Contains("largest error up to 500 ms / m"));
    CHECK_THAT(svg, Catch::Contains("fill=\"white\" stroke=\"#0072b2\""));
    CHECK_THAT(svg, Catch::Contains("tsit5: none ended"));
}

TEST_CASE("of runs that were timed twice the page says what their median is", "[unit]") {
    CHECK_THAT(accuracy_page(sample()),
               Catch::Contains("medians of as many runs as the table tells (of two their"));
    CHECK_THAT(accuracy_page(sample()), Catch::Contains("<td>0.25</td><td>2</td><td>1000</td><td>done</td>"));
}

TEST_CASE("what is printed begins with the horizon and the reference", "[unit]") {
    const auto all = accuracy_sentences(sample());
    REQUIRE(all.size() == 3);
    CHECK_THAT(all[0], Catch::StartsWith("conditioning: "));
    CHECK_THAT(all[1], Catch::StartsWith("reference: rk4 at 10 us, confirmed by verlet at 1 us to 1e-09 m"));
}
