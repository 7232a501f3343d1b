#include "output/run_report.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;
using nlohmann::json;

namespace {

void require_finite(const json& value) {
    if (value.is_number_float()) REQUIRE(std::isfinite(value.get<double>()));
    if (value.is_structured())
        for (const auto& [key, each] : value.items()) require_finite(each);
}

}  // namespace

TEST_CASE("the report of a run has every key that others rely on, and finite figures only", "[scene]") {
    const Folder folder;
    const std::string scene =
        folder.write("scene.toml", "[scene]\nname = \"walk\"\nduration = 1\nstep = 0.1\nseed = 7\n[counter]\n");
    const Outcome outcome = run_program(
        {"run", scene, "--quiet", "--modules", fixture("counter"), "--report", folder.path("r.json")});
    REQUIRE(outcome.code == 0);
    const json report = json::parse(read_file(folder.path("r.json")));
    for (const char* key : {"scene", "seed", "simulated_s", "wall_s", "real_time_factor", "outcome",
                            "state_hash", "loaded_libraries", "modules"}) {
        CAPTURE(key);
        CHECK(report.contains(key));
    }
    require_finite(report);
    CHECK(report["scene"] == "walk");
    CHECK(report["seed"] == 7);
    CHECK(report["simulated_s"].get<double>() == Approx(1));
    CHECK(report["real_time_factor"].get<double>() ==
          Approx(report["simulated_s"].get<double>() / report["wall_s"].get<double>()));
    CHECK(report["outcome"] == "done");
    CHECK(report["state_hash"].get<std::string>().size() == 16);
    const auto libraries = report["loaded_libraries"].get<std::vector<std::string>>();
    CHECK(std::count(libraries.begin(), libraries.end(), fixture("counter") + "/counter.so") == 1);

    REQUIRE(report["modules"].size() == 1);
    const json& module = report["modules"][0];
    CHECK(module["name"] == "counter");
    CHECK(module["method"] == "counting");
    CHECK(module["steps"] == 10);
    CHECK(module["setup_s"].get<double>() > 0);
    CHECK(module["wall_s"].get<double>() > 0);
    CHECK(module["memory_bytes"] == 1000 + 8 + 2 * 24 + 8);
    CHECK(module["error_estimate"] ==
          json({{"value", 0.5}, {"unit", "m"}, {"how", "half a step"}, {"wall_s", 0}}));
    CHECK(module["measures"]["pictures"] == 0);
    CHECK(module["measures"]["label"] == "a \"quoted\" name");
    CHECK(module["measures"]["never"].is_null());
}

TEST_CASE("a report is valid JSON whatever a module says of itself", "[extreme]") {
    RunReport report;
    report.scene = "half a letter \xC3";
    report.message = std::string("zero \0 and \x01 and \"quotes\"\n", 27);
    RunReport::ModuleEntry entry;
    entry.name = "web";
    entry.report.has_error = true;
    entry.report.error = {std::nan(""), "m", "?"};
    entry.report.measure("infinite", std::numeric_limits<double>::infinity());
    entry.report.measure("largest", std::numeric_limits<std::int64_t>::max());
    report.modules.push_back(entry);
    const json read = json::parse(report_json(report));
    CHECK(read["modules"][0]["measures"]["infinite"].is_null());
    CHECK(read["modules"][0]["measures"]["largest"] == std::numeric_limits<std::int64_t>::max());
    CHECK(read["modules"][0]["error_estimate"]["value"].is_null());
    CHECK(read["message"] == report.message);
    CHECK(read["real_time_factor"] == 0);
}

TEST_CASE("an error of which nothing is known is not told as a number", "[unit]") {
    RunReport report;
    RunReport::ModuleEntry entry;
    entry.name = "web";
    entry.report.has_error = true;
    entry.report.error = {std::nan(""), "m", "no frame was redone yet"};
    report.modules.push_back(entry);
    CHECK_THAT(report_text(report), Catch::EndsWith("not known (no frame was redone yet)\n"));
}

TEST_CASE("a module that approximates nothing says so", "[unit]") {
    RunReport report;
    report.scene = "still";
    report.outcome = "done";
    RunReport::ModuleEntry entry;
    entry.name = "sky";
    report.modules.push_back(entry);
    CHECK(json::parse(report_json(report))["modules"][0]["error_estimate"].is_null());
    const std::string text = report_text(report);
    CHECK_THAT(text, Catch::StartsWith("still: done, 0 frames, 0 s simulated in 0 s, 0 x real time, state "
                                       "0000000000000000\n"));
    CHECK_THAT(text, Catch::Contains("sky") && Catch::EndsWith("none: nothing is approximated over time\n"));
}
