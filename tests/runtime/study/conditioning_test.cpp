#include "study/conditioning.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// What twins of the oscillator would be run by if its manifest said so, at a longest step of 4 ms.
std::string twins(const std::vector<std::pair<std::string, std::string>>& changes,
                  const std::vector<std::string>& references) {
    OscillatorScene scene;
    std::string manifest = read_file(fixture("oscillator") + "/oscillator.toml");
    for (const auto& [before, after] : changes) {
        REQUIRE(manifest.find(before) != std::string::npos);
        manifest.replace(manifest.find(before), before.size(), after);
    }
    std::filesystem::create_directories(scene.folder.path("modules"));
    scene.folder.write("modules/oscillator.so", "");
    scene.folder.write("modules/oscillator.toml", manifest);
    scene.settings.run.module_directories = {scene.folder.path("modules")};
    scene.settings.references = references;
    return to_string(twin_rung(Subject(scene.settings), [](const std::string&) { return 0.004; }));
}

}  // namespace

TEST_CASE("twins are run by equal steps where a method of reference has them", "[unit]") {
    // A frame of 10 ms has three steps of at most 4 ms.
    CHECK(twins({}, {"rk4", "adaptive"}) == "rk4 at 3.33 ms");
    CHECK(twins({}, {"adaptive", "rk4"}) == "rk4 at 3.33 ms");
    const std::pair<std::string, std::string> both{"tolerances = [", "tolerances = [\"rk4\", "};
    CHECK(twins({both}, {"adaptive", "rk4"}) == "rk4 at 3.33 ms");
    CHECK(twins({both}, {"rk4", "verlet"}) == "verlet at 3.33 ms");
}

TEST_CASE("the tolerance of twins lies far below their distance, and far above rounding", "[unit]") {
    const std::pair<std::string, std::string> only{"\"rk4\"]\ntolerances = [", "]\ntolerances = [\"rk4\", "};
    const std::pair<std::string, std::string> free{"min = 1e-13", "min = 1e-20"};
    CHECK(twins({only, free}, {"rk4", "adaptive"}) == "rk4 at a tolerance of 1e-12 m");
    const std::pair<std::string, std::string> coarse{"min = 1e-13", "min = 1e-9"};
    CHECK(twins({only, coarse}, {"rk4", "adaptive"}) == "rk4 at a tolerance of 1e-09 m");
}

TEST_CASE("only what is free to move is displaced, each by the length asked", "[unit]") {
    OscillatorScene scene("growth = 30");
    const Subject subject(scene.settings);
    const auto offsets =
        free_offsets(scene.settings, subject, subject.overrides({"rk4", 0.001, 0}), 1e-10, scene.deadline);
    REQUIRE(offsets.size() == 4);
    CHECK(offsets[0] == Vec3{});
    CHECK(norm(offsets[1]) == Approx(1e-10));
    CHECK(norm(offsets[2]) == Approx(1e-10));
    CHECK(norm(offsets[1] - offsets[2]) > 1e-12);
}

TEST_CASE("twins of an unstable place part as cosh does, and the horizon is where 1e-10 m became 1e-6",
          "[unit]") {
    const double growth = 80;  // 1/s: cosh(80 t) = 1e4 at 0.1238 s
    OscillatorScene scene("growth = 80");
    const Subject subject(scene.settings);
    TrialPlan plan{subject.overrides({"rk4", 1e-4, 0}), 0.2};
    const Trial trial = run_trial(scene.settings, subject, plan, scene.deadline);
    plan.offsets = free_offsets(scene.settings, subject, plan.overrides, kDisplacement, scene.deadline);
    const Trial twin = run_trial(scene.settings, subject, plan, scene.deadline);
    const Conditioning found = judge(trial.motion, twin.motion);
    REQUIRE(found.deviation_m.size() == 21);
    // The displaced place is the origin, so that not even rounding comes in between; rk4 adds (80 h)^4/120 a
    // time.
    for (std::size_t i = 0; i < 21; ++i)
        CHECK(found.deviation_m[i] ==
              Approx(1e-10 * std::cosh(growth * 0.01 * static_cast<double>(i))).epsilon(1e-6));
    CHECK_FALSE(found.whole);
    CHECK(found.horizon_rows == 13);  // rows 0 to 12, the last at 0.12 s
    CHECK(found.horizon_s == Approx(0.12));
    CHECK(found.statistics_row() == 12);
    CHECK_THAT(sentence(found), Catch::Contains("has grown past 1e-06 m after 120 ms"));
}

TEST_CASE("twins that stay together have the whole run as their horizon", "[unit]") {
    Motion motion{1, 0.1, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
    Motion twin = motion;
    twin.positions[2].y = 1e-7;
    const Conditioning found = judge(motion, twin);
    CHECK(found.whole);
    CHECK(found.horizon_rows == 3);
    CHECK(found.statistics_row() == 0);
    CHECK(found.horizon_s == Approx(0.2));
    CHECK_THAT(sentence(found), Catch::Contains("over the whole run"));
}

TEST_CASE("a horizon before the first frame is the first frame", "[extreme]") {
    Motion motion{1, 0.1, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
    Motion twin = motion;
    twin.positions[1].y = std::nan("");
    CHECK(judge(motion, twin).horizon_rows == 2);
}
