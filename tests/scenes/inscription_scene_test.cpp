#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

std::vector<std::string> written_scenes() {
    std::vector<std::string> names{"some_pig"};
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(ORBWEAVER_SOURCE_DIR) + "/assets/scenes/charlotte"))
        names.push_back("charlotte/" + entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

struct Written {
    std::string mode;
    std::map<std::string, double> measures;
};

Written written_in(const OpenScene& scene) {
    for (const auto& instance : scene.session->instances()) {
        if (instance->manifest().id != "inscription") continue;
        const ModuleReport report = instance->report();
        Written written{report.method, {}};
        for (const auto& [name, value] : report.measures)
            written.measures[name] = std::holds_alternative<double>(value)
                                         ? std::get<double>(value)
                                         : static_cast<double>(std::get<std::int64_t>(value));
        return written;
    }
    FAIL("nothing writes in this scene");
    return {};
}

}  // namespace

TEST_CASE("each of Charlotte's webs is written in as its mode does it", "[scene]") {
    const std::string name = GENERATE(from_range(written_scenes()));
    CAPTURE(name);
    const OpenScene scene = open_scene(name);
    REQUIRE(scene.session->faults().empty());
    auto [mode, measures] = written_in(scene);
    CAPTURE(mode);
    CHECK(measures["iou"] > measures["iou_plain"]);
    if (mode == "legible") {
        CHECK(measures["iou"] > 0.7);
        CHECK(measures["contrast"] > 2);
        CHECK(measures["naturalness_loss"] <= 0.3);
        CHECK(measures["new_slack_threads"] == 0);
        CHECK(measures["max_tension_ratio"] <= 1.5);
    } else {
        CHECK((measures["threads_removed"] > 0) == (mode != "crosshatch"));
        CHECK((measures["threads_added"] > 0) == (mode == "crosshatch" || mode == "random_attachments"));
        CHECK((measures["parts_thickened"] > 0) == (mode == "outline"));
        CHECK((measures["contrast"] > 1) == (mode == "crosshatch" || mode == "random_attachments"));
    }
}

TEST_CASE("what is written, and how it moves then, does not depend on threads", "[scene]") {
    Request two;
    two.threads = 2;
    const OpenScene one_thread = open_scene("some_pig"), two_threads = open_scene("some_pig", two);
    for (int i = 0; i < 2; ++i) {
        one_thread.session->step();
        two_threads.session->step();
    }
    CHECK(one_thread.session->state_hash() == two_threads.session->state_hash());
}

TEST_CASE("a swaying web is looked at as often as asked, and not unless asked", "[scene]") {
    const OpenScene quiet = open_scene("some_pig");
    const OpenScene watched = open_scene("some_pig", {}, {"inscription.watch=20 ms"});
    for (int i = 0; i < 3; ++i) {
        quiet.session->step();
        watched.session->step();
    }
    CHECK(written_in(quiet).measures.count("iou_swaying_mean") == 0);
    auto measures = written_in(watched).measures;
    CHECK(measures["iou_swaying_least"] > 0.5);
    CHECK(measures["iou_swaying_mean"] >= measures["iou_swaying_least"]);
}
