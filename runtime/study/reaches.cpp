#include "study/reaches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "study/pareto.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

namespace {

constexpr const char* kReading =
    "Each mark is a way of bending limbs to the same targets, at one tolerance or with so many steps of one "
    "search: "
    "what a target takes, and how far at most a limb's end is from it, in lengths of the limb, by the limb's "
    "own "
    "geometry, whatever the way says of itself. Lower left is better; hollow marks miss some target by more "
    "than the "
    "tolerance, or say that they reached what they did not. Times are medians of processor time.";

using Effort = ReachWays::Effort;

/// What is varied: the tolerance of a whole search, or the steps of one.
struct Ladder {
    const char* suffix;   ///< of the kind's name
    const char* meaning;  ///< after the kind's
    std::vector<Effort> efforts;
};

std::vector<Ladder> ladders() {
    Ladder tolerances{"", "by tolerance", {}};
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
        tolerances.efforts.push_back({tolerance, 0});
    Ladder steps{"_steps", "by steps of one search", {}};
    for (const int count : {1, 2, 3, 5, 8, 13, 21}) steps.efforts.push_back({0, count});
    return {tolerances, steps};
}

std::string text_of(const Effort& effort) {
    if (effort.steps > 0) return fmt::format("{} step{}", effort.steps, effort.steps == 1 ? "" : "s");
    return fmt::format("tolerance {:.0e}", effort.tolerance);
}

class ReachContest final : public Contest {
public:
    explicit ReachContest(ReachWays& of) : of_(of), ladders_(ladders()) {
        for (const ReachWays::Named& way : of.ways()) ways_.push_back({way.name, way.meaning});
        for (const ReachWays::Named& kind : of.kinds())
            for (const Ladder& ladder : ladders_)
                tasks_.push_back({kind.name + std::string(ladder.suffix),
                                  fmt::format("{}, {}", kind.meaning, ladder.meaning)});
        for (const Ladder& ladder : ladders_) {
            settings_.emplace_back();
            for (const Effort& effort : ladder.efforts) settings_.back().push_back(text_of(effort));
        }
    }

    const std::vector<Named>& tasks() const override { return tasks_; }
    const std::vector<Named>& ways() const override { return ways_; }
    const std::vector<std::string>& settings(std::size_t tasks) const override {
        return settings_[tasks % ladders_.size()];
    }
    std::size_t count(std::size_t tasks) const override { return of_.count(kind(tasks)); }
    bool suits(std::size_t, std::size_t) const override { return true; }
    void run(std::size_t tasks, std::size_t way, std::size_t setting) override {
        of_.reach(way, kind(tasks), effort(tasks, setting), {});
    }
    void judge(std::size_t tasks, std::size_t way, std::size_t setting, WayRow& row) override {
        std::vector<ReachWays::Reach> reaches(count(tasks));
        of_.reach(way, kind(tasks), effort(tasks, setting), reaches);
        constexpr double kRounding = 1 + 1e-9;
        const double tolerance = effort(tasks, setting).tolerance * kRounding;
        std::vector<double> errors;
        for (const ReachWays::Reach& each : reaches) {
            errors.push_back(each.error);
            if (tolerance == 0 || each.error <= tolerance) continue;
            ++(each.claimed ? row.invented : row.missed);
        }
        set_errors(std::move(errors), row);
    }

private:
    std::size_t kind(std::size_t tasks) const { return tasks / ladders_.size(); }
    const Effort& effort(std::size_t tasks, std::size_t setting) const {
        return ladders_[tasks % ladders_.size()].efforts[setting];
    }

    ReachWays& of_;
    std::vector<Ladder> ladders_;
    std::vector<Named> tasks_, ways_;
    std::vector<std::vector<std::string>> settings_;  // one a ladder
};

/// What each way takes to come within `bound`, the cheapest first.
std::string within_sentence(const WaysResult& result, const Named& set, double bound) {
    std::vector<WayRow> best;
    std::string never;
    for (const Named& way : result.ways) {
        std::vector<WayRow> rows = result.rows_of(set.name);
        std::erase_if(rows, [&](const WayRow& row) { return row.way != way.name; });
        std::vector<CostError> points;
        points.reserve(rows.size());
        for (const WayRow& row : rows) points.push_back({row.cost_s, row.error});
        if (const auto cheapest = cheapest_within(points, bound))
            best.push_back(rows[*cheapest]);
        else
            for (const WayRow& row : rows)
                if (row.setting == text_of({bound, 0}))
                    never += fmt::format("{}{} ({} of {} missed)", never.empty() ? "; not " : ", ", way.name,
                                         row.missed + row.invented, row.asked);
    }
    std::sort(best.begin(), best.end(), [](const WayRow& a, const WayRow& b) { return a.cost_s < b.cost_s; });
    std::string said;
    for (const WayRow& row : best)
        said += fmt::format("{}{} {} ({})", said.empty() ? "" : ", ", row.way, seconds_text(row.cost_s),
                            row.setting);
    return fmt::format("{}: within {:.0e} of a limb's length: {}{}", set.name, bound,
                       said.empty() ? "nobody" : said, never);
}

std::string false_claims(const WaysResult& result) {
    std::string said;
    for (const WayRow& row : result.rows)
        if (row.invented > 0)
            said += fmt::format("{}{} at {}, {}: {} of {}", said.empty() ? "" : "; ", row.way, row.setting,
                                row.tasks, row.invented, row.asked);
    return said.empty() ? "no way says that it reached what it did not"
                        : "said to be reached, and not: " + said;
}

}  // namespace

WaysResult study_reaches(const StudySettings& settings, const std::string& scene, ReachWays& ways,
                         const Deadline& deadline) {
    WaysResult result;
    result.words = {"ik",
                    "targets",
                    "target",
                    "reaching",
                    "",
                    "largest error / limb lengths",
                    fmt::format("reach of {} limbs", ways.limbs()),
                    kReading,
                    true};
    result.scene = scene;
    result.facts = {{"limbs", ways.limbs()}};
    ReachContest contest(ways);
    study_ways(settings, contest, deadline, result);
    for (std::size_t set = 0; set < result.tasks.size(); set += ladders().size())  // those by tolerance
        if (!result.rows_of(result.tasks[set].name).empty())
            for (const double bound : {1e-2, 1e-4, 1e-6, 1e-8})
                result.sentences.push_back(within_sentence(result, result.tasks[set], bound));
    if (!result.rows.empty()) result.sentences.push_back(false_claims(result));
    return result;
}

}  // namespace orbweaver::study
