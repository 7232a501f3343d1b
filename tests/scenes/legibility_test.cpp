#include <catch2/catch.hpp>

#include "sanitized.hpp"
#include "shipped_scenes.hpp"
#include "study/web_readings.hpp"
#include "written_otherwise.hpp"

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

/// What is read in a scene's web at some times.
std::vector<ReadingRow> readings(const std::string& path, int seed, const std::vector<double>& times) {
    RunSettings run;
    run.scene_path = path;
    run.module_directories = {ORBWEAVER_MODULE_DIR};
    run.overrides = {"scene.seed=" + std::to_string(seed)};
    const auto reader = Reader::find();
    REQUIRE(reader);  // tools/setup check installs it
    Request studied;
    studied.collects = {WritingWays::kContract};
    const OpenScene opened = open_scene_file(run.scene_path, studied, run.overrides);
    auto* writing = opened.session->find<WritingWays>();
    REQUIRE(writing->ways()[0].name == std::string("legible"));
    return WebReadings(run, *reader, writing->text(), writing->blur(), times)
        .of("legible", writing->write(0, {}));
}

double mean_error(const std::vector<ReadingRow>& rows, bool blurred, double ReadingRow::*error) {
    double sum = 0, count = 0;
    for (const ReadingRow& row : rows)
        if (row.is_blurred == blurred) {
            sum += row.*error;
            count += 1;
        }
    return sum / count;
}

}  // namespace

// Blurred by one mesh. A page that shows the same place of the same web with nothing written is the control.
TEST_CASE("words written legibly are read, and where nothing is written nothing is", "[image]") {
    const std::string scene =
        GENERATE("charlotte/pig", "some_pig", "charlotte/terrific", "charlotte/radiant", "charlotte/humble");
    double written = 0, plain = 0;
    const int seeds = repetitions(10);
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto rows = readings(scene_path(scene), seed, {0});
        INFO(scene << ", seed " << seed << ": " << rows.back().read);
        CHECK(rows.back().error <= 0.34);  // two letters of six
        written += mean_error(rows, true, &ReadingRow::error) / seeds;
        plain += mean_error(rows, true, &ReadingRow::plain_error) / seeds;
    }
    CAPTURE(scene);
    CHECK(written <= 0.1);
    CHECK(plain >= 0.8);
}

TEST_CASE("words are still read in the meadow's wind", "[image]") {
    const std::vector<double> times = kSanitized ? std::vector{0.1} : std::vector{0.5, 1.0, 1.5, 2.0, 2.5, 3.0};
    const auto rows = readings(scene_path("some_pig"), 1, times);
    CHECK(mean_error(rows, true, &ReadingRow::error) <= 0.3);
    CHECK(mean_error(rows, true, &ReadingRow::plain_error) >= 0.8);
}

TEST_CASE("small letters and digits are read as capitals are", "[image]") {
    const Folder folder("legibility");
    for (const char* text : {"pig", "Pig 42"}) {
        CAPTURE(text);
        const std::string lines = "text = \"" + std::string(text) + "\"";
        const auto rows = readings(written_otherwise(folder, lines), 1, {0});
        CHECK(mean_error(rows, true, &ReadingRow::error) <= 0.2);
        CHECK(mean_error(rows, true, &ReadingRow::plain_error) >= 0.8);
    }
}
