#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

using namespace orbweaver::test;

TEST_CASE("duration, step and seed are overrides, numbers or texts with a unit", "[scene]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", "[scene]\nduration = 9\n[counter]\n");
    for (const auto& [duration, step] : {std::pair("0.5", "0.1"), std::pair("500 ms", "1/10 s")}) {
        const Outcome outcome =
            run_program({"run", scene, "--duration", duration, "--step", step, "--seed", "5", "--report",
                         folder.path("report.json"), "--modules", fixture("counter")});
        CHECK(outcome.code == 0);
        const auto report = nlohmann::json::parse(read_file(folder.path("report.json")));
        CHECK(report["frames"] == 5);
        CHECK(report["step_s"] == 0.1);
        CHECK(report["seed"] == 5);
    }
}

TEST_CASE("what is typed wrongly is named with what was expected", "[extreme]") {
    for (const auto& [option, value, sentence] :
         {std::tuple("--duration", "soon", "'soon' is not a time; expected seconds or a text such as \"20 s\""),
          std::tuple("--seed", "-1", "'-1' is not a seed; expected a whole number from 0 on"),
          std::tuple("--set", "foo", "'foo' is not an override; expected path.to.key=value")}) {
        const Outcome outcome = run_program({"plan", "scene.toml", option, value});
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err, Catch::Contains(sentence));
    }
}
