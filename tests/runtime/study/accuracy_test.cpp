#include "study/accuracy.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

constexpr double kOmega = 10;

/// Verlet from rest swings exactly, but by an angle of 2 asin(omega h/2) a step. The largest error up to a
/// frame.
double verlet_error(double h, int frames) {
    const double theta = 2 * std::asin(kOmega * h / 2);
    double largest = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        const double t = 0.01 * frame;
        largest = std::max(largest, std::abs(0.1 * std::cos(theta * t / h) - 0.1 * std::cos(kOmega * t)));
    }
    return largest;
}

AccuracyResult studied(OscillatorScene& scene) {
    const Subject subject(scene.settings);
    return study_accuracy(scene.settings, subject, scene.deadline);
}

}  // namespace

TEST_CASE("the study finds the errors that theory gives", "[unit]") {
    OscillatorScene scene;
    const AccuracyResult result = studied(scene);
    CHECK(result.duration_s == 0.2);
    CHECK(result.particles == 4);
    CHECK(result.conditioning.whole);
    CHECK(result.reference.method == "rk4");
    CHECK(result.second.method == "verlet");
    CHECK(result.uncertainty_m < 1e-12);
    CHECK(result.displacement_m == Approx(0.1 - 0.1 * std::cos(2.0)));
    int verlets = 0;
    for (const AccuracyRow& row : result.rows) {
        if (row.rung.method != "verlet") continue;
        ++verlets;
        CAPTURE(row.rung.step);
        REQUIRE(row.outcome == "done");
        CHECK(*row.error_m == Approx(verlet_error(row.rung.step, 20)).epsilon(1e-3));
        CHECK(row.steps == static_cast<std::uint64_t>(std::llround(0.2 / row.rung.step)));
        CHECK(row.wall_s > 0);
    }
    CHECK(verlets == 9);
    CHECK(result.rows.size() == 36);
}

TEST_CASE("a ladder of tolerances is climbed as one of steps is", "[unit]") {
    OscillatorScene scene;
    scene.settings.methods = {"adaptive"};
    const AccuracyResult result = studied(scene);
    REQUIRE(result.rows.size() == 9);
    CHECK(result.rows[0].rung.tolerance == 1e-3);
    CHECK(result.rows[0].rung.step == 0);
    CHECK(result.rows[8].rung.tolerance == Approx(1e-11));
    CHECK(*result.rows[8].error_m < 1e-10);
    CHECK_THAT(result.sentences.front(), Catch::Contains("adaptive at a tolerance of"));
}

TEST_CASE("every promise is the cheapest run that keeps it, the reference's doubt included", "[unit]") {
    OscillatorScene scene;
    const AccuracyResult result = studied(scene);
    REQUIRE_FALSE(result.front.empty());
    double error = HUGE_VAL;
    for (const std::size_t i : result.front) {
        CHECK(*result.rows[i].error_m < error);
        error = *result.rows[i].error_m;
    }
    CHECK_THAT(result.sentences.front(), Catch::StartsWith("within 1e"));
}

TEST_CASE("runs that do not end are rows of their own, without an error", "[unit]") {
    OscillatorScene scene("omega = 2000");
    const AccuracyResult result = studied(scene);
    const auto diverged = std::count_if(result.rows.begin(), result.rows.end(), [](const AccuracyRow& row) {
        return row.outcome == "diverged" && !row.error_m && !row.deviation;
    });
    CHECK(diverged >= 4);
}

TEST_CASE("errors within the reference's own are marked", "[unit]") {
    OscillatorScene scene;
    const AccuracyResult result = studied(scene);
    for (const AccuracyRow& row : result.rows)
        if (row.error_m) CHECK((row.outcome == "unresolved") == (*row.error_m < 3 * result.uncertainty_m));
}

TEST_CASE("errors are measured up to the horizon only", "[unit]") {
    // Twins part past 1e-6 m at 0.124 s; in one frame after the other nothing else changes.
    OscillatorScene scene("growth = 80");
    const AccuracyResult result = studied(scene);
    CHECK_FALSE(result.conditioning.whole);
    CHECK(result.conditioning.horizon_s == Approx(0.12));
    for (const AccuracyRow& row : result.rows) {
        if (row.rung.method != "verlet" || row.outcome != "done") continue;
        CHECK(*row.error_m == Approx(verlet_error(row.rung.step, 12)).epsilon(1e-3));
        CHECK(row.deviation);
    }
    CHECK(result.conditioning.rung.method == "rk4");
    // From 0.12 s on the twin differs from the other by what grew, and the statistics tell that alone.
    CHECK(result.twin.shape_m > 1e-6);
    CHECK(result.statistics.spectrum.size() == 4);  // of the rows 12 to 20
    const auto said = std::find_if(result.sentences.begin(), result.sentences.end(),
                                   [](const std::string& text) { return text.starts_with("beyond 120 ms: "); });
    REQUIRE(said != result.sentences.end());
    for (const char* what : {"the mean energy by", "the mean shape by", "the spectrum by", "of 36 runs differ"})
        CHECK_THAT(*said, Catch::Contains(what));
}

TEST_CASE("every run is timed as often as asked, where there is time", "[unit]") {
    OscillatorScene scene;
    scene.settings.repeats = 3;
    scene.settings.methods = {"verlet"};
    for (const AccuracyRow& row : studied(scene).rows) CHECK(row.runs == 3);
}

TEST_CASE("where nothing moves it is said that there is nothing to compare", "[extreme]") {
    OscillatorScene scene("amplitude = 0\nbystander = 0");
    const AccuracyResult result = studied(scene);
    CHECK(result.displacement_m == 0);
    CHECK(result.front.size() <= 1);
    REQUIRE(result.sentences.size() == 1);
    CHECK_THAT(result.sentences[0], Catch::StartsWith("nothing moves"));
}

TEST_CASE("a study ends within its time, or says that it was too short", "[extreme]") {
    OscillatorScene scene("delay = 0.005");  // 0.1 s a run
    const Subject subject(scene.settings);
    const AccuracyResult result = study_accuracy(scene.settings, subject, deadline_in(2.5, scene.interrupt));
    CHECK(result.rows.size() < 36);
    CHECK_THAT(result.sentences.back(), Catch::Contains("left out for lack of time: "));
    CHECK(kind_of_fault([&] { study_accuracy(scene.settings, subject, deadline_in(0.01, scene.interrupt)); }) ==
          FaultKind::limit);
}

TEST_CASE("a method that does not take the scene is refused with its reason, and the others are studied",
          "[unit]") {
    OscillatorScene scene("bystander = 200");
    const AccuracyResult result = studied(scene);
    for (const AccuracyRow& row : result.rows)
        CHECK((row.outcome == "refused") == (row.rung.method == "explicit"));
    CHECK(result.sentences.back() ==
          "explicit: refused down to its finest rung: module 'oscillator' failed while attaching: explicit "
          "takes no "
          "bystander beyond 100 m, and not 200 m");
}
