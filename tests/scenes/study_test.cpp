#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "program.hpp"
#include "sanitized.hpp"
#include "scratch.hpp"
#include "shipped_scenes.hpp"
#include "study/accuracy.hpp"
#include "study/accuracy_files.hpp"
#include "study/run_study.hpp"
#include "study/stability.hpp"

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

constexpr double kPatience = kSanitized ? 10 : 1;  ///< sanitizers slow down what deadlines do not wait for

struct StudiedScene {
    StudySettings settings;
    Interrupt interrupt;
    Deadline deadline = deadline_in(kPatience * 60, interrupt);

    StudiedScene(const std::string& name, const std::vector<std::string>& methods) {
        settings.run.scene_path = scene_path(name);
        settings.run.module_directories = {ORBWEAVER_MODULE_DIR};
        settings.run.quiet = true;
        settings.methods = methods;
        settings.repeats = 1;
    }

    StabilityResult map(const std::vector<std::string>& axes) const {
        std::vector<AxisText> parsed;
        parsed.reserve(axes.size());
        for (const std::string& axis : axes) parsed.push_back(*parse_axis(axis));
        return study_stability(settings, Subject(settings), parsed, deadline);
    }

    void shorten(const std::string& duration) {
        settings.run.overrides.push_back("scene.duration=" + duration);
        settings.full_duration = true;
    }
};

}  // namespace

TEST_CASE("twins of two methods that may go by tolerance are run by equal steps", "[scene]") {
    StudiedScene scene("strand", {"rk4"});
    scene.settings.references = {"tsit5", "tr_bdf2"};
    scene.shorten("0.05");
    scene.deadline = deadline_in(kPatience * 10, scene.interrupt);
    const AccuracyResult result = study_accuracy(scene.settings, Subject(scene.settings), scene.deadline);
    CHECK(result.conditioning.rung.method == "tsit5");
    CHECK(result.conditioning.rung.step > 0);
    CHECK(result.conditioning.rung.tolerance == 0);
    // The strand is damped: what its twin is displaced by does not grow.
    CHECK(*std::max_element(result.conditioning.deviation_m.begin(), result.conditioning.deviation_m.end()) <
          10 * kDisplacement);
}

TEST_CASE("the web of the thesis leaves its horizon within tenths of a second, and is compared beyond it",
          "[scene]") {
    StudiedScene scene("thesis_web", {"symplectic_euler"});
    scene.shorten("0.1");
    scene.settings.run.overrides.insert(scene.settings.run.overrides.end(),
                                        {"scene.step=10 ms", "web.spiral.density=1",
                                         "web.spokes.placement=14 mm", "web.outer_frame.placement=10 mm"});
    scene.deadline = deadline_in(kPatience * 40, scene.interrupt);
    const AccuracyResult result = study_accuracy(scene.settings, Subject(scene.settings), scene.deadline);
    CHECK_FALSE(result.conditioning.whole);
    CHECK(result.conditioning.horizon_s < 0.1);
    CHECK(*std::max_element(result.conditioning.deviation_m.begin(), result.conditioning.deviation_m.end()) >
          1e-3);
    CHECK(result.twin.energy > 0);
    CHECK(result.twin.shape_m > 1e-6);
    CHECK(result.twin.spectrum > 0);
    const auto sentences = accuracy_sentences(result);
    CHECK(std::any_of(sentences.begin(), sentences.end(), [](const std::string& text) {
        return text.starts_with("beyond ") && text.find("mean energy") != std::string::npos;
    }));
}

TEST_CASE("the map of the thesis's web reaches the step that the thesis asks for", "[scene]") {
    StudiedScene scene("thesis_web", {"rk4"});
    scene.shorten("0.02");
    const StabilityResult result = scene.map({"web.stiffness_scale=1,2"});
    CHECK(result.asked_step_s == 0.02);
    CHECK(result.axes.x.values.back() == 0.02);
    CHECK(*result.maps[0].taken_step_s < 0.001);
    CHECK(result.maps[0].cells[result.axes.columns() - 1] != CellClass::stable);
}

TEST_CASE("an axis may change how many particles there are, and which", "[scene]") {
    StudiedScene scene("strand", {"rk4"});
    scene.shorten("0.05");
    const StabilityResult result = scene.map({"web.step=0.1,0.2 ms", "web.strand.placement=2,5,10 mm"});
    for (const CellClass kind : result.maps[0].cells) CHECK(kind == CellClass::stable);
}

TEST_CASE("winds and materials are axes by their names", "[scene]") {
    StudiedScene scene("strand", {"verlet"});
    scene.shorten("0.05");
    scene.settings.run.overrides.insert(scene.settings.run.overrides.end(),
                                        {"wind.model=steady", "wind.velocity=[1, 0, 0]"});
    const StabilityResult winds = scene.map({"wind.model=calm,steady,thesis", "web.settle=false,true"});
    for (const CellClass kind : winds.maps[0].cells) CHECK(kind == CellClass::stable);
    CHECK(winds.axes.x.own == 1);
    CHECK(winds.axes.y.own == 0);
}

TEST_CASE("a species is studied by its name, and as the scene has it", "[scene]") {
    const test::Scratch folder;
    StudySettings settings;
    settings.run.module_directories = {ORBWEAVER_MODULE_DIR};
    settings.run.quiet = true;
    settings.repeats = 1;
    settings.methods = {"half_jacobian_lanes"};
    settings.out = folder.path("out");
    const auto page_of = [&](const std::string& scene) {
        settings.run.scene_path = scene;
        run_reaches(settings);
        std::stringstream page;
        page << std::ifstream(folder.path("out/index.html")).rdbuf();
        return page.str();
    };
    CHECK_THAT(page_of("ant"),
               Catch::Contains("<title>ant: reach of 6 limbs</title>") &&
                   Catch::Contains("cold: within 1e-08 of a limb's length: half_jacobian_lanes "));
    CHECK_THAT(page_of(scene_path("huntsman_cube")), Catch::Contains("reach of 8 limbs</title>"));
    settings.run.scene_path = "huntsmann";
    CHECK_THROWS_WITH(run_reaches(settings), Catch::Contains("there is no species 'huntsmann'") &&
                                                 Catch::Contains("did you mean \"huntsman\"?"));
}

TEST_CASE("queries of a surface are answered by every module that can, FCL's too", "[scene]") {
    const test::Scratch folder;
    StudySettings settings;
    settings.run.scene_path = folder.write("floor.toml", "[surface]\nfloor = \"4 m\"\n");
    settings.run.module_directories = {ORBWEAVER_MODULE_DIR};
    settings.run.quiet = true;
    settings.repeats = 1;
    settings.out = folder.path("out");
    run_queries(settings);
    std::stringstream csv_text;
    csv_text << std::ifstream(folder.path("out/queries.csv")).rdbuf();
    const std::string csv = csv_text.str();
    for (const char* way : {"walker", "wide_tree", "every_triangle", "closest_point", "fcl_tree"})
        CHECK_THAT(csv, Catch::Contains(std::string("underfoot,") + way + ",2000,0,0,"));
}

TEST_CASE("a reader that hangs takes no more than the study's time, and nothing that was measured",
          "[extreme]") {
    const Folder folder("study_inscription");
    const std::string reader = folder.write("tesseract", "#!/bin/sh\nsleep 1000\n");
    std::filesystem::permissions(reader, std::filesystem::perms::owner_all);
    const std::string out = folder.path("out"), time = std::to_string(static_cast<int>(kPatience * 10));
    const Outcome outcome =
        run_program("study inscription '" + scene_path("charlotte/pig") + "' --out '" + out +
                        "' --method removal --repeats 1 --duration 0.02 --quiet --time " + time,
                    "PATH='" + folder.path("") + "':$PATH");
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.text, Catch::Contains("removal and what follows it was not read for lack of time"));
    CHECK(std::filesystem::exists(out + "/trade.csv"));
}
