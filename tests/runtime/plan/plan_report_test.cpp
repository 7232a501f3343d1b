#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "plan/plan.hpp"
#include "support/manifests.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

ManifestFolder two_modules() {
    ManifestFolder folder;
    folder.add("web",
               "table = \"web\"\nseveral = true\nphases = [\"sense\", \"derive\"]\nlibraries = [\"Eigen\"]");
    folder.add("window", "when = \"window\"\nprovides = [\"canvas/1\"]\nlibraries = [\"SDL2\", \"GL\"]");
    return folder;
}

}  // namespace

TEST_CASE("the plan for a program says everything that the plan holds", "[unit]") {
    const ManifestFolder folder = two_modules();
    const Planned planned(folder.catalog(), "[scene]\nname = \"a \\\"b\\\"\"\n[[web]]\n[[web]]\nx = 1\n");
    const auto json = nlohmann::json::parse(plan_json(planned.plan));
    CHECK(json["scene"] == "a \"b\"");
    REQUIRE(json["modules"].size() == 2);
    CHECK(json["modules"][1] == nlohmann::json({{"name", "web.2"},
                                                {"module", "web"},
                                                {"version", "1"},
                                                {"reason", "the scene has [web], number 2"},
                                                {"library", folder.path() + "/web.so"},
                                                {"brings", {"Eigen"}},
                                                {"phases", {"sense", "derive"}},
                                                {"notes", nlohmann::json::array()}}));
    CHECK(json["left_out"] == nlohmann::json::array({{{"module", "window"},
                                                      {"reason", "nobody asked for a window (--window)"},
                                                      {"would_bring", {"SDL2", "GL"}}}}));
    REQUIRE(json["faults"].size() == 1);
    CHECK(json["faults"][0]["file"] == "scene.toml");
    CHECK(json["faults"][0]["line"] == 5);
    CHECK(json["faults"][0]["column"] == 1);
    CHECK(json["faults"][0]["what"] == "there is no option 'x'");
    CHECK(json["faults"][0].contains("expected"));
    CHECK(json["faults"][0].contains("remedy"));
}

TEST_CASE("the plan for a program is valid whatever bytes the scene holds", "[extreme]") {
    const ManifestFolder folder = two_modules();
    // A name of 57 bytes and then half a letter, where a shortened text is cut.
    const std::string scene = "[scene]\nstep = \"" + std::string(56, 'x') + "\xC3\xA4 and more\"\n";
    const Planned planned(folder.catalog(), scene);
    REQUIRE(planned.plan.faults.size() == 1);
    CHECK_NOTHROW(nlohmann::json::parse(plan_json(planned.plan)));
}

TEST_CASE("the plan for a person reads line by line", "[unit]") {
    const ManifestFolder folder = two_modules();
    CHECK(plan_text(Planned(folder.catalog(), "[web]\n").plan) ==
          "scene scene\n\n"
          "loaded, in this order:\n"
          "  web              the scene has [web] [Eigen]\n\n"
          "left out:\n"
          "  window           nobody asked for a window (--window) [SDL2, GL]\n");
    CHECK_THAT(plan_text(Planned(folder.catalog(), "[scene]\nsed = 1\n").plan),
               Catch::Contains("  nothing: the scene asks for no module\n") &&
                   Catch::EndsWith(
                       "\n1 fault, so this plan cannot be run:\n  scene.toml:2:1: there is no option 'sed'; "
                       "expected one of name, duration, step, seed or gravity; did you mean 'seed'?\n"));
}

TEST_CASE("a module's manifest may add to the plan what an option of the scene comes to", "[unit]") {
    const ManifestFolder folder;
    folder.add("surface",
               "table = \"surface\"\n[options.floor]\ntype = \"number\"\nunit = \"m\"\nmeaning = \"edge\"\n"
               "plan = \"a flat floor: no tree is built\"\n"
               "[options.size]\ntype = \"number\"\nunit = \"m\"\ndefault = 1\nmeaning = \"extent\"\n"
               "plan = \"scaled\"");
    const Planned floor(folder.catalog(), "[surface]\nfloor = \"4 m\"\n");
    CHECK_THAT(plan_text(floor.plan), Catch::Contains("  surface          the scene has [surface]\n"
                                                      "                   a flat floor: no tree is built\n\n"));
    const auto json = nlohmann::json::parse(plan_json(floor.plan));
    CHECK(json["modules"][0]["notes"] == nlohmann::json({"a flat floor: no tree is built"}));
    const Planned bare(folder.catalog(), "[surface]\n");
    CHECK_THAT(plan_text(bare.plan), !Catch::Contains("floor") && !Catch::Contains("scaled"));
}
