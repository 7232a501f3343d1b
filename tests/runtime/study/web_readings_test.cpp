#include "study/web_readings.hpp"

#include <catch2/catch.hpp>

#include "support/fake_reader.hpp"
#include "support/opened_scene.hpp"
#include "support/painted_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

constexpr double kBlur = 0.006;
/// As long as what is read of two blocks, and as random: no two pictures are read equally wrongly but by
/// chance.
const std::string kText =
    "ILAOHBFDLPHMDHAGNIFMFCEOEEAAGGFFJKGGFGMJALNFEICKJAKCJLJPKFPPFBIA"
    "LMANLMAOBFGDHOLLIODLJBNCGKLEKICJKJFCEJPFBCMBHLIONEBBPKGEENDFNLEB";

/// As many squares as a way's name has letters, all nine where nothing is written; they drift.
const char* const kTables = R"(
[inscription]
[view]
half = 0.004
drift = [0.01, 0.02, 0]
middles = [[0, 0, 0], [0.02, 0.003, 0], [0.01, -0.012, 0], [-0.011, 0, 0], [-0.02, 0.01, 0],
           [-0.021, -0.013, 0], [0.003, -0.004, 0], [0.025, 0.015, 0], [-0.001, 0.011, 0]]
)";

WritingWays::Outcome written(double contrast, std::size_t blocks = 2) {
    WritingWays::Outcome outcome;
    outcome.contrast = contrast;
    outcome.blocks = {{{}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0.02, -0.01, 0}, {0.008, 0, 0}, {0, 0.006, 0}}};
    outcome.blocks.resize(blocks);
    return outcome;
}

/// What is read in a web of that scene, looked at by hand.
struct Expected {
    std::vector<std::string> plain, blurred;  ///< at each time, of all blocks

    Expected(const RunSettings& run, const std::vector<WritingWays::Block>& blocks,
             const std::vector<double>& times, bool negative) {
        const Reader reader = *Reader::find();
        const auto text = [&](picture::GrayPicture picture) {
            for (std::uint8_t& shade : picture.shades)
                if (negative) shade = static_cast<std::uint8_t>(255 - shade);
            return reader.read(picture);
        };
        for (const auto& look : photograph(run, {blocks, 1.5 * kBlur, kBlur, kBlur / 6}, times)) {
            plain.emplace_back();
            blurred.emplace_back();
            for (const BlockPictures& block : look) {
                plain.back() += text(block.plain);
                blurred.back() += text(block.blurred);
            }
        }
    }
};

RunSettings with_mode(RunSettings run, const std::string& mode) {
    run.overrides.push_back("inscription.mode=\"" + mode + "\"");
    return run;
}

RunSettings without_inscription(RunSettings run) {
    run.removals.push_back("inscription");
    return run;
}

/// Lines parted by '/'.
std::string in_one_line(std::string text) {
    text.pop_back();
    std::replace(text.begin(), text.end(), '\n', '/');
    return text;
}

void check_rows(const std::vector<ReadingRow>& rows, const std::string& way, const std::vector<double>& times,
                const Expected& seen, const Expected& bare) {
    REQUIRE(rows.size() == 2 * times.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool blurred = i >= times.size();
        const std::size_t look = i % times.size();
        const std::string& read = (blurred ? seen.blurred : seen.plain)[look];
        CHECK(rows[i].way == way);
        CHECK(rows[i].time == times[look]);
        CHECK(rows[i].is_blurred == blurred);
        CHECK(rows[i].read == in_one_line(read));
        CHECK(rows[i].error == character_error_rate(read, kText));
        CHECK(rows[i].plain_error == character_error_rate((blurred ? bare.blurred : bare.plain)[look], kText));
    }
}

}  // namespace

TEST_CASE("what a way wrote is read as it is and blurred, beside the web without it, at every time", "[unit]") {
    const FakeReader fake;
    const Reader reader = *Reader::find();
    const PaintedScene scene(kTables);
    const std::vector<double> times{0, 0.3};
    const double contrast = GENERATE(2.0, 1.0, 0.5);  // below 1: the negative is read
    const auto outcome = written(contrast);
    WebReadings readings(scene.run, reader, kText, kBlur, times);
    const Expected bare(without_inscription(scene.run), outcome.blocks, times, contrast < 1);
    for (const std::string way : {"abc", "abcde"})
        check_rows(readings.of(way, outcome), way, times,
                   {with_mode(scene.run, way), outcome.blocks, times, contrast < 1}, bare);
}

TEST_CASE("each way is held against the bare web where it wrote, though another wrote elsewhere", "[unit]") {
    const FakeReader fake;
    const Reader reader = *Reader::find();
    const PaintedScene scene(kTables);
    const std::vector<double> times{0};
    WebReadings readings(scene.run, reader, kText, kBlur, times);
    auto aside = written(2), wider = aside, higher = aside;
    aside.blocks[1].middle.y += 0.005;
    wider.blocks[0].right.x += 0.003;
    higher.blocks[0].up.y += 0.003;
    for (const auto& outcome : {written(2), aside, written(2, 1), written(2), wider, written(2), higher})
        check_rows(readings.of("abc", outcome), "abc", times,
                   {with_mode(scene.run, "abc"), outcome.blocks, times, false},
                   {without_inscription(scene.run), outcome.blocks, times, false});
}

TEST_CASE("the bare web stays bare whatever a command line said of the inscription", "[unit]") {
    const FakeReader fake;
    const Reader reader = *Reader::find();
    const PaintedScene scene(kTables);
    const std::vector<double> times{0};
    RunSettings asked = scene.run;
    asked.overrides = {GENERATE("inscription.more=3", "inscription={more=3}"), "view.half=0.003"};
    RunSettings bare = scene.run;
    bare.overrides = {"view.half=0.003"};
    const auto outcome = written(2);
    WebReadings readings(asked, reader, kText, kBlur, times);
    check_rows(readings.of("ab", outcome), "ab", times, {with_mode(asked, "ab"), outcome.blocks, times, false},
               {without_inscription(bare), outcome.blocks, times, false});
}

TEST_CASE("runs that are read ask no module for anything beyond their scene", "[unit]") {
    const FakeReader fake;
    const Reader reader = *Reader::find();
    PaintedScene scene(kTables);
    scene.run.request.collects = {"tally/1"};
    const std::vector<double> times{0};
    const auto outcome = written(2);
    WebReadings readings(scene.run, reader, kText, kBlur, times);
    scene.run.request.collects.clear();
    check_rows(readings.of("abc", outcome), "abc", times,
               {with_mode(scene.run, "abc"), outcome.blocks, times, false},
               {without_inscription(scene.run), outcome.blocks, times, false});
}
