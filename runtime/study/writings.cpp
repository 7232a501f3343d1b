#include "study/writings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "orbweaver/fault.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

namespace {

constexpr const char* kReading =
    "Each mark is a way of writing the same in the same web: the time that it takes until the web is at rest "
    "again, and "
    "the share of target and what is read, together, in which both differ, at a viewer's distance. Every way "
    "is judged "
    "on one fine raster, whatever raster it worked on. Lower left is better. Of the ways of the thesis those "
    "that take "
    "silk are judged by their negative. Times are medians of processor time.";

using Effort = WritingWays::Effort;

class WritingContest final : public Contest {
public:
    explicit WritingContest(WritingWays& of) : of_(of) {
        for (const WritingWays::Named& way : of.ways()) ways_.push_back({way.name, way.meaning});
        for (const std::uint32_t side : {75U, 150U, 300U, 600U, 1200U})
            add(0, {side, {}}, fmt::format("{} pixels", side));
        for (const double loss : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5})
            add(1, {{}, loss}, fmt::format("loss {}", loss));
        add(2, {}, "");
    }

    const std::vector<Named>& tasks() const override { return tasks_; }
    const std::vector<Named>& ways() const override { return ways_; }
    const std::vector<std::string>& settings(std::size_t tasks) const override { return settings_[tasks]; }
    std::size_t count(std::size_t) const override { return 1; }
    bool suits(std::size_t tasks, std::size_t way) const override { return tasks != 1 || of_.weighs_loss(way); }
    void run(std::size_t tasks, std::size_t way, std::size_t setting) override {
        last_ = of_.write(way, efforts_[tasks][setting]);
    }
    void judge(std::size_t tasks, std::size_t way, std::size_t setting, WayRow& row) override {
        set_errors({1 - last_.iou}, row);
        if (tasks > 0) trade.push_back({ways_[way].name, settings_[tasks][setting], last_});
    }

    std::vector<TradeRow> trade;

private:
    void add(std::size_t tasks, const Effort& effort, const std::string& text) {
        efforts_[tasks].push_back(effort);
        settings_[tasks].push_back(text);
    }

    WritingWays& of_;
    std::vector<Named> tasks_ = {{"raster", "by the pixels of a side of the raster on which it is written"},
                                 {"nature", "by the share of the web's silk that may change"},
                                 {"as_it_is", "as the scene has it"}};
    std::vector<Named> ways_;
    std::vector<Effort> efforts_[3];
    std::vector<std::string> settings_[3];
    WritingWays::Outcome last_;
};

std::string trade_sentence(const WritingsResult& result) {
    std::string said;
    for (const TradeRow& row : result.trade)
        if (row.setting.empty())
            said += fmt::format("{}{} {:.2f} for {:.0f} %", said.empty() ? "" : ", ", row.way, row.outcome.iou,
                                100 * row.outcome.silk_share);
    return said.empty() ? "no way was tried as the scene has it"
                        : "agreement with what was to be written, for silk that changed: " + said;
}

/// Mean rates of one way, over all times.
std::string reading_sentence(const WritingsResult& result, const std::string& way) {
    double sums[2] = {0, 0}, plain = 0, worst = 0;
    double counts[2] = {0, 0};
    for (const ReadingRow& row : result.readings) {
        if (row.way != way) continue;
        sums[row.is_blurred ? 1 : 0] += row.error;
        counts[row.is_blurred ? 1 : 0] += 1;
        if (!row.is_blurred) continue;
        plain += row.plain_error;
        worst = std::max(worst, row.error);
    }
    return fmt::format(
        "{}: of its characters {:.2f} are read wrongly as it is, {:.2f} from a distance (at most {:.2f}); "
        "{:.2f} where nothing is written",
        way, sums[0] / counts[0], sums[1] / counts[1], worst, plain / counts[1]);
}

/// Why nothing of it can be read; empty: it can.
std::string cannot_read(const std::string& text, bool has_reader) {
    if (text.empty()) return "it is no text, so nothing was read";
    if (!has_reader) return "nothing was read: PATH has no tesseract; install tesseract-ocr";
    if (const auto beyond = unreadable_in(text))
        return fmt::format(
            "nothing was read: '{}' is not of ASCII, beyond which the reader's English does not reach; "
            "study words of plain letters, digits and signs",
            *beyond);
    return "";
}

std::string late_sentence(const std::string& way, const Deadline& deadline) {
    return fmt::format("{} and what follows it was not read {}", way, deadline.why_passed());
}

/// What keeps one way from being read keeps no other, and nothing that was measured, from being written down.
void read_all(const StudySettings& settings, const WritingWays& writing, const std::vector<double>& times,
              const Deadline& deadline, WritingsResult& result) {
    std::vector<std::string>& sentences = result.ways.sentences;
    const auto reader = Reader::find();
    if (const std::string why = cannot_read(writing.text(), reader.has_value()); !why.empty())
        return sentences.push_back(why);
    WebReadings readings(settings.run, *reader, writing.text(), writing.blur(), times);
    for (const TradeRow& written : result.trade) {
        if (!written.setting.empty()) continue;
        if (deadline.passed()) return sentences.push_back(late_sentence(written.way, deadline));
        try {
            const auto rows = readings.of(written.way, written.outcome, [&] { return deadline.passed(); });
            result.readings.insert(result.readings.end(), rows.begin(), rows.end());
            sentences.push_back(reading_sentence(result, written.way));
        } catch (const Fault& fault) {
            if (fault.kind() == FaultKind::stopped)
                return sentences.push_back(late_sentence(written.way, deadline));
            sentences.push_back(written.way + " was not read: " + fault.what());
        }
    }
}

}  // namespace

WritingsResult study_writings(const StudySettings& settings, const std::string& scene, WritingWays& writing,
                              const std::vector<double>& times, const Deadline& deadline) {
    if (!writing.has_web())
        throw Fault(FaultKind::invalid,
                    scene + ": it has no orb web to write in; expected a table such as [web] with a species");
    WritingsResult result;
    result.ways.words = {"inscription",        "tasks",  "text", "writing", "", "target not met / share",
                         "writing in its web", kReading, true};
    result.ways.scene = scene;
    WritingContest contest(writing);
    study_ways(settings, contest, deadline, result.ways);
    result.trade = std::move(contest.trade);
    result.ways.sentences.push_back(trade_sentence(result));
    read_all(settings, writing, times, deadline, result);
    return result;
}

}  // namespace orbweaver::study
