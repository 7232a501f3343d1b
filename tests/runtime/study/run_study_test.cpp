#include "study/run_study.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

TEST_CASE("each study leaves its files", "[scene]") {
    OscillatorScene scene;
    run_accuracy(scene.settings);
    run_stability(scene.settings, {});
    CHECK(Folder::names_in(scene.settings.out) ==
          std::vector<std::string>{"accuracy.csv", "accuracy.json", "accuracy.svg", "accuracy_statistics.csv",
                                   "index.html", "stability.csv", "stability.json", "stability.svg"});
    CHECK_THAT(read_file(scene.settings.out + "/index.html"),
               Catch::Contains("swing: where each method holds"));
}

TEST_CASE("a study that fails leaves nothing", "[extreme]") {
    OscillatorScene scene;
    scene.settings.time = 1e-6;
    CHECK(kind_of_fault([&] { run_accuracy(scene.settings); }) == FaultKind::limit);
    CHECK_FALSE(std::filesystem::exists(scene.settings.out));
}

TEST_CASE("a scene without a surface has no queries to study, and one without limbs no reach", "[extreme]") {
    OscillatorScene scene;
    CHECK(kind_of_fault([&] { run_queries(scene.settings); }) == FaultKind::invalid);
    CHECK_THROWS_WITH(run_reaches(scene.settings),
                      scene.settings.run.scene_path +
                          ": it has 0 tables of creatures with limbs; expected one, such as [spider]");
    CHECK_FALSE(std::filesystem::exists(scene.settings.out));
}
