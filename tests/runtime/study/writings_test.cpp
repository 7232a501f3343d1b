#include "study/writings.hpp"

#include <signal.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "support/fake_reader.hpp"
#include "support/opened_scene.hpp"
#include "support/painted_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// Two ways, of which the first weighs loss. What comes of each tells how it was asked.
class Pens final : public WritingWays {
public:
    std::span<const Named> ways() const noexcept override {
        static constexpr Named kWays[] = {{"brush", "weighs"}, {"pen", "does not"}};
        return kWays;
    }
    bool weighs_loss(std::size_t way) const noexcept override { return way == 0; }
    const std::string& text() const noexcept override {
        if (!text_.empty() && signals) {
            ::kill(::getpid(), SIGINT);
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        }
        return text_;
    }
    bool has_web() const noexcept override { return web; }
    double blur() const noexcept override { return 0.006; }
    Outcome write(std::size_t way, const Effort& effort) override {
        Outcome outcome;
        outcome.iou = way == 0 ? 0.75 : 0.5;
        if (effort.side) outcome.iou = *effort.side / 2000.0;
        if (effort.loss) outcome.iou = *effort.loss;
        outcome.silk_share = way == 0 ? 0.125 : 0.25;
        outcome.contrast = 2;
        outcome.blocks = {{{}, {half_width, 0, 0}, {0, 0.01, 0}}};
        return outcome;
    }

    bool web = true, signals = false;
    double half_width = 0.01;
    std::string text_;
};

struct Studied {
    PaintedScene scene{
        "[inscription]\n[view]\nhalf = 0.002\ndrift = [0.01, 0, 0]\n"
        "middles = [[0, 0, 0], [0.006, 0, 0], [-0.006, 0, 0], [0, 0.006, 0], [0, -0.006, 0], [0.006, 0.006, "
        "0]]\n"};
    StudySettings settings;
    Interrupt interrupt;
    Pens pens;
    std::vector<double> times{0, 0.3};

    Studied() {
        settings.run = scene.run;
        settings.repeats = 1;
    }
    WritingsResult study(double seconds = kSanitized ? 600 : 60) {
        return study_writings(settings, "webs", pens, times, deadline_in(seconds, interrupt));
    }
};

}  // namespace

TEST_CASE("every way writes on each raster and as the scene has it, and with each loss that it weighs",
          "[unit]") {
    Studied studied;
    const WritingsResult result = studied.study();
    const std::vector<std::string> losses{"0.02", "0.05", "0.1", "0.15", "0.2", "0.3", "0.5"};
    std::vector<std::array<std::string, 3>> expected;
    std::vector<double> ious;
    for (const char* way : {"brush", "pen"})
        for (const int side : {75, 150, 300, 600, 1200}) {
            expected.push_back({"raster", way, std::to_string(side) + " pixels"});
            ious.push_back(side / 2000.0);
        }
    for (const std::string& loss : losses) {
        expected.push_back({"nature", "brush", "loss " + loss});
        ious.push_back(std::stod(loss));
    }
    expected.push_back({"as_it_is", "brush", ""});
    expected.push_back({"as_it_is", "pen", ""});
    ious.insert(ious.end(), {0.75, 0.5});
    REQUIRE(result.ways.rows.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const WayRow& row = result.ways.rows[i];
        CHECK(std::array{row.tasks, row.way, row.setting} == expected[i]);
        CHECK(row.error == 1 - ious[i]);
        CHECK(row.median_error == 1 - ious[i]);
        CHECK((row.asked == 1 && row.missed == 0 && row.invented == 0));
    }
    REQUIRE(result.trade.size() == losses.size() + 2);  // rasters trade nothing
    for (std::size_t i = 0; i < result.trade.size(); ++i) {
        CHECK(result.trade[i].way == expected[10 + i][1]);
        CHECK(result.trade[i].setting == expected[10 + i][2]);
        CHECK(result.trade[i].outcome.iou == ious[10 + i]);
    }
}

TEST_CASE("a study of writing says what it is of, and what came of each way as the scene has it", "[unit]") {
    Studied studied;
    const WritingsResult result = studied.study();
    CHECK(result.ways.scene == "webs");
    CHECK(result.ways.words.name == "inscription");
    CHECK(result.ways.words.has_settings);
    REQUIRE(result.ways.ways.size() == 2);
    CHECK(result.ways.ways[1].name == "pen");
    CHECK(result.ways.ways[1].meaning == "does not");
    CHECK(result.ways.sentences ==
          std::vector<std::string>{"agreement with what was to be written, for silk that changed: brush 0.75 "
                                   "for 12 %, pen 0.50 for 25 %",
                                   "it is no text, so nothing was read"});
    CHECK(result.readings.empty());
}

TEST_CASE("words are read of each way as the scene has it, and their rates are told as means", "[unit]") {
    const FakeReader fake;
    Studied studied;
    studied.pens.text_ = "OCABPFEMDHKLAINGJBCP";
    const WritingsResult result = studied.study();
    const Reader reader = *Reader::find();
    WebReadings readings(studied.settings.run, reader, studied.pens.text_, 0.006, studied.times);
    std::size_t i = 0;
    REQUIRE(result.readings.size() == 2 * 2 * studied.times.size());
    REQUIRE(result.ways.sentences.size() == 3);
    for (const std::size_t way : {0U, 1U}) {
        const std::string name = studied.pens.ways()[way].name;
        double plain = 0, sharp = 0, blurred = 0, worst = 0;
        for (const ReadingRow& row : readings.of(name, studied.pens.write(way, {}))) {
            CHECK(result.readings[i].way == name);
            CHECK(result.readings[i].read == row.read);
            CHECK(result.readings[i++].error == row.error);
            (row.is_blurred ? blurred : sharp) += row.error / 2;
            if (!row.is_blurred) continue;
            plain += row.plain_error / 2;
            worst = std::max(worst, row.error);
        }
        CHECK(result.ways.sentences[1 + way] ==
              fmt::format("{}: of its characters {:.2f} are read wrongly as it is, {:.2f} from a distance (at "
                          "most {:.2f}); {:.2f} where nothing is written",
                          name, sharp, blurred, worst, plain));
    }
}

TEST_CASE("where there is no reader, that is said and all else is studied", "[unit]") {
    Studied studied;
    studied.settings.methods = {"pen"};
    studied.pens.text_ = "PIG";
    const Folder empty;
    const Surrounded path("PATH", empty.path());
    const WritingsResult result = studied.study();
    CHECK(result.trade.size() == 1);
    CHECK(result.ways.sentences.back() == "nothing was read: PATH has no tesseract; install tesseract-ocr");
    CHECK(result.readings.empty());
}

TEST_CASE("a scene without a web to write in, and a way that there is not, are refused", "[unit]") {
    Studied studied;
    studied.settings.methods = {"pencil"};
    CHECK_THROWS_WITH(studied.study(), Catch::StartsWith("--method pencil: there is no such way of writing; "
                                                         "expected brush or pen"));
    studied.pens.web = false;
    CHECK(kind_of_fault([&] { studied.study(); }) == FaultKind::invalid);
    CHECK(fault_of([&] { studied.study(); }) ==
          "webs: it has no orb web to write in; expected a table such as [web] with a species");
}

TEST_CASE("what no time was left for is said", "[extreme]") {
    const FakeReader fake;
    Studied studied;
    const WritingsResult none = studied.study(0);
    CHECK(none.trade.empty());
    REQUIRE(none.ways.sentences.size() > 2);
    CHECK(none.ways.sentences[none.ways.sentences.size() - 2] == "no way was tried as the scene has it");
    studied.pens.text_ = "PIG";
    studied.pens.signals = true;  // once all is written, before anything is read
    const WritingsResult unread = studied.study();
    CHECK(unread.trade.size() == 9);
    CHECK(unread.readings.empty());
    CHECK(unread.ways.sentences.back() == "brush and what follows it was not read when interrupted");
}

TEST_CASE("what keeps a way from being read is said, and keeps nothing that was measured from the study",
          "[extreme]") {
    const Folder folder;
    write_script(folder, "tesseract", "exit 1\n");
    const Surrounded path("PATH", folder.path());
    Studied studied;
    studied.pens.text_ = "PIG";
    const std::string failed =
        " was not read: " + folder.path("tesseract") + " failed; see whether it reads a picture by itself";
    const WritingsResult result = studied.study();
    CHECK(result.trade.size() == 9);
    CHECK(result.readings.empty());
    REQUIRE(result.ways.sentences.size() == 3);
    CHECK(result.ways.sentences[1] == "brush" + failed);
    CHECK(result.ways.sentences[2] == "pen" + failed);
    studied.pens.half_width = 1000;
    CHECK_THAT(studied.study().ways.sentences[1],
               Catch::StartsWith("brush was not read: a picture in which the web's meshes can be told") &&
                   Catch::EndsWith("study a web of fewer turns"));
}

TEST_CASE("a way that can be read is, after one that could not", "[extreme]") {
    const Folder folder;  // a reader that fails once
    write_script(folder, "tesseract", "[ -e $0.failed ] && echo PIG && exit 0\n: > $0.failed\nexit 1\n");
    const Surrounded path("PATH", folder.path());
    Studied studied;
    studied.pens.text_ = "PIG";
    const WritingsResult result = studied.study();
    CHECK(result.ways.sentences[1].starts_with("brush was not read: "));
    REQUIRE(result.readings.size() == 2 * studied.times.size());
    CHECK(result.readings[0].way == "pen");
    CHECK(result.readings[0].error == 0);
}

TEST_CASE("a reader that hangs is given up in time", "[extreme]") {
    const Folder folder;
    write_script(folder, "tesseract", "while true; do :; done\n");
    const Surrounded path("PATH", folder.path());
    Studied studied;
    studied.pens.text_ = "PIG";
    const WritingsResult result = studied.study(kSanitized ? 20 : 2);
    CHECK(result.trade.size() == 9);
    CHECK(result.ways.sentences.back() == "brush and what follows it was not read for lack of time");
}

TEST_CASE("words that the reader may not know are not read, which is said", "[extreme]") {
    const FakeReader fake;
    Studied studied;
    studied.pens.text_ = "CAF\u00c9";
    const WritingsResult result = studied.study();
    CHECK(result.readings.empty());
    CHECK(result.ways.sentences.back() ==
          "nothing was read: '\u00c9' is not of ASCII, beyond which the reader's English does not reach; study "
          "words "
          "of plain letters, digits and signs");
}
