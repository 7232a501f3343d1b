#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "program.hpp"
#include "run/snapshot.hpp"
#include "shipped_scenes.hpp"
#include "written_otherwise.hpp"

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

TEST_CASE("words are written as well from a baked target, and whatever blanks part them", "[scene]") {
    const Folder folder("inscription");
    const double expected = written_in(open_scene("some_pig")).measures["iou"];
    const std::string baked = folder.path("pig.baked");
    const std::string bake =
        std::string(ORBWEAVER_ASSETS_PROGRAM) + " target --text 'SOME\\nPIG' -o '" + baked + "' > /dev/null";
    REQUIRE(std::system(bake.c_str()) == 0);
    for (const std::string& lines : {"target = \"" + baked + "\"", std::string("text = \" SOME  PIG \""),
                                     std::string("text = \"SOME\\n\\nPIG\\n\"")}) {
        CAPTURE(lines);
        CHECK(written_in(open_scene_file(written_otherwise(folder, lines))).measures["iou"] == expected);
    }
    // Two lines and a blank one, wider apart, are a block above and one below the hub all the same.
    auto measures = written_in(open_scene_file(written_otherwise(
                                   folder, "text = \"SOME\\n \\nPIG\\n\"\nlines = \"as_written\"")))
                        .measures;
    CHECK(measures["iou"] > 0.8);
    CHECK(measures.count("block_2_left_m") == 1);
}

TEST_CASE("what a scene cannot have written is its fault, told with its place", "[extreme]") {
    const Folder folder("inscription");
    const std::string no_orb = "the scene has no orb web to write in; expected a table [web]";
    const std::string strand = scene_path("strand"), pig = scene_path("charlotte/pig");
    std::ifstream file(strand);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const auto line = 2 + std::count(text.begin(), text.end(), '\n');
    const std::string written_strand = folder.write("strand.toml", text + "[inscription]\ntext = \"PIG\"\n");
    const std::string webless =
        folder.write("webless.toml", "[scene]\nduration = 1\n[inscription]\ntext = \"PIG\"\n");
    const std::vector<std::tuple<std::string, std::vector<std::string>, std::string>> cases = {
        {written_strand, {}, written_strand + ":" + std::to_string(line) + ":8: " + no_orb},
        {webless, {}, webless + ":4:8: " + no_orb},
        {pig,
         {"inscription.size=1e-9"},
         "--set inscription.size: nothing of what is to be written lies on the web"},
        {pig,
         {"inscription.position=[5,5]"},
         "--set inscription.position: nothing of what is to be written lies on the web"},
        {pig, {"web.spiral.start=1 m"}, pig + ":16:8: the web has no spiral to write in"},
        {pig, {"inscription.threshold=0.4"}, "--set inscription.threshold: 'threshold' has no effect on words"},
        {pig, {"inscription.gaps_seed=4"}, "--set inscription.gaps_seed: 'gaps_seed' has no effect on words"},
        {pig, {"inscription.mode=random_gaps"}, pig + ":16:8: mode 'random_gaps' writes no 'text'"},
        {pig, {"inscription.score_threshold=0"}, "--set inscription.score_threshold: "},
        {pig, {"inscription.low_pass=100.1"}, "--set inscription.low_pass: "},
        {pig, {"inscription.line_spacing=0.09"}, "--set inscription.line_spacing: "}};
    for (const auto& [scene, overrides, sentence] : cases) {
        CAPTURE(scene, overrides);
        std::string arguments = "run '" + scene + "' --headless --duration 0.02 --quiet";
        for (const std::string& each : overrides) arguments += " --set '" + each + "'";
        const Outcome outcome = run_program(arguments);
        CHECK(outcome.code == 3);
        CHECK_THAT(outcome.text, Catch::StartsWith(sentence));
        CHECK(outcome.text.find("module 'web'") == std::string::npos);
    }
}

TEST_CASE("what is cut at the page's edge counts as missed, and is told", "[scene]") {
    const std::string there = "inscription.position=[0,0.05]", beyond = "inscription.position=[0,0.3]";
    const OpenScene whole = open_scene("some_pig", {}, {there}), cut = open_scene("some_pig", {}, {beyond});
    CHECK(written_in(whole).measures["cut_share"] < 0.05);
    CHECK(written_in(cut).measures["cut_share"] > 0.4);
    CHECK(written_in(cut).measures["iou"] < 1 - written_in(cut).measures["cut_share"]);
    const Outcome outcome = run_program("run '" + scene_path("some_pig") +
                                        "' --headless --duration 0.02 --quiet --set '" + beyond + "'");
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.text,
               Catch::Contains("% of what is to be written lies beside the web's page and is cut"));
}

TEST_CASE("looks at a swaying web go on where a state was saved", "[scene]") {
    const std::vector<std::string> watched{"inscription.watch=20 ms"};
    const OpenScene first = open_scene("some_pig", {}, watched), second = open_scene("some_pig", {}, watched);
    for (int i = 0; i < 3; ++i) first.session->step();
    restore_snapshot(*second.session, save_snapshot(*first.session), "state");
    for (int i = 0; i < 3; ++i)
        for (const OpenScene* each : {&first, &second}) each->session->step();
    auto expected = written_in(first).measures, found = written_in(second).measures;
    for (const char* name : {"iou_swaying_mean", "iou_swaying_least"}) CHECK(found[name] == expected[name]);
    CHECK(first.session->state_hash() == second.session->state_hash());
}
