#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <variant>

#include "scratch.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

ModuleReport report_of(const OpenScene& scene, const std::string& module) {
    for (const auto& each : scene.session->instances())
        if (each->manifest().id == module) return each->report();
    FAIL("there is no " + module);
    return {};
}

double measure(const ModuleReport& report, const std::string& name) {
    for (const auto& [key, value] : report.measures)
        if (key == name) return std::get<double>(value);
    FAIL("there is no measure " + name);
    return 0;
}

/// m that one huntsman walks in ten seconds straight ahead on a floor.
double walked(const std::vector<std::string>& overrides) {
    std::vector<std::string> all{"spider.rests=false", "spider.wander.displacement=0"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    OpenScene scene = open_scene("huntsman_cube", {}, all);
    for (int i = 0; i < 600; ++i) scene.session->step();
    return measure(report_of(scene, "spider"), "distance_walked_m");
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const auto at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), with);
}

}  // namespace

TEST_CASE("creatures walk as their species' file says, unless the scene says otherwise", "[scene]") {
    const test::Scratch folder;
    const std::string file = text_of(std::string(ORBWEAVER_SOURCE_DIR) + "/assets/creatures/huntsman.toml");
    const std::string slow =
        folder.write("slow.toml", replaced(file, "speed = \"0.146 m/s\"", "speed = \"0.05 m/s\""));
    const std::string wave =
        folder.write("wave.toml", replaced(file, "gait = \"tetrapod\"", "gait = \"wave\""));
    const double as_shipped = walked({}), slowly = walked({"spider.species=" + slow});
    CHECK(slowly < 0.05 * 10);
    CHECK(slowly > 0.05 * 10 / 2);  // slower at corners
    CHECK(as_shipped > 1.5 * slowly);
    CHECK(walked({"spider.speed=0.05"}) == slowly);
    CHECK(walked({"spider.species=" + slow, "spider.speed=0.146"}) == as_shipped);
    CHECK(walked({"spider.species=" + wave}) == walked({"spider.gait=wave"}));
    CHECK(walked({"spider.species=" + wave, "spider.gait=tetrapod"}) == as_shipped);
    CHECK(walked({"spider.gait=wave"}) != as_shipped);
}

TEST_CASE("a skin is made when somebody looks, and changes no state", "[scene]") {
    Request pictures;
    pictures.pictures = true;
    pictures.width = 64;
    pictures.height = 48;
    OpenScene headless = open_scene("huntsman_cube"), seen = open_scene("huntsman_cube", pictures);
    for (int i = 0; i < 3; ++i) {
        headless.session->step();
        seen.session->step();
        seen.session->present();
    }
    const auto without = report_of(headless, "spider").memory_bytes;
    CHECK(without < 20'000);
    CHECK(report_of(seen, "spider").memory_bytes > without + 100'000);
    CHECK(seen.session->state_hash() == headless.session->state_hash());
}
