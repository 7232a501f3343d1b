#include "study/queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "study/query_questions.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

namespace {

constexpr std::size_t kMostQuestions = 2000;
constexpr std::size_t kFewestQuestions = 100;
constexpr std::size_t kReferenceTriangles = 200'000'000;  // asked by the reference for each kind: about 2 s

constexpr const char* kReading =
    "Each mark is a way of asking the same questions: what one takes, and how far at most the place found "
    "lies from where it should. Lower left is better; errors of 0 lie on the lower edge; hollow marks miss "
    "something or find what is not there. The reference asks every triangle in extended precision, and knows "
    "nothing of trees, neighbours or walks; where a ray meets nothing but a rim, to hit it and to pass it are "
    "both right. Beyond an edge the reference is the nearest point of the surface. Times are medians of "
    "processor "
    "time, of questions asked one after the other.";

/// Questions to a surface, asked of all modules that offer ways.
class QueryContest final : public Contest {
public:
    QueryContest(const Surface& surface, std::uint64_t seed, const std::vector<SurfaceWays*>& offers)
        : surface_(surface),
          sets_(make_questions(
              surface, seed,
              std::clamp(kReferenceTriangles / surface.faces().size(), kFewestQuestions, kMostQuestions))) {
        for (const QuestionSet& set : sets_) tasks_.push_back({set.name, set.meaning});
        for (SurfaceWays* each : offers)
            for (std::size_t i = 0; i < each->ways().size(); ++i) {
                offers_.push_back({each, i});
                ways_.push_back({each->ways()[i].name, each->ways()[i].meaning});
            }
    }

    const std::vector<Named>& tasks() const override { return tasks_; }
    const std::vector<Named>& ways() const override { return ways_; }
    const std::vector<std::string>& settings(std::size_t) const override { return settings_; }
    std::size_t count(std::size_t tasks) const override { return sets_[tasks].questions.size(); }
    bool suits(std::size_t tasks, std::size_t way) const override {
        return sets_[tasks].suits(offers_[way].of->ways()[offers_[way].number].finds);
    }
    void run(std::size_t tasks, std::size_t way, std::size_t) override {
        hits_.resize(count(tasks));
        offers_[way].of->answer(offers_[way].number, sets_[tasks].questions, hits_);
    }
    void judge(std::size_t tasks, std::size_t way, std::size_t, WayRow& row) override {
        std::vector<double> errors;
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            const QueryTruth& truth = sets_[tasks].truths[i];
            if (hits_[i].answer == Answer::failed)
                throw Fault(FaultKind::limit, fmt::format("{}: no memory for what it needs; use a coarser mesh",
                                                          ways_[way].name));
            if (hits_[i].answer != Answer::found) {
                row.missed += truth.certain;
                continue;
            }
            row.invented += truth.places.empty();
            double error = HUGE_VAL;
            const Vec3 found = surface_.position(hits_[i].at);
            for (const Vec3& place : truth.places) error = std::min(error, distance(place, found));
            if (!truth.places.empty()) errors.push_back(error);
        }
        set_errors(std::move(errors), row);
    }

private:
    /// One way of one module.
    struct Offer {
        SurfaceWays* of;
        std::size_t number;
    };

    const Surface& surface_;
    std::vector<QuestionSet> sets_;
    std::vector<Offer> offers_;
    std::vector<Named> tasks_, ways_;
    std::vector<std::string> settings_{""};
    std::vector<SurfaceHit> hits_;
};

std::string misses_sentence(const WaysResult& result, const Named& set) {
    std::string said;
    std::size_t asked = 0;
    for (const WayRow& row : result.rows_of(set.name)) {
        asked = row.asked;
        if (row.missed + row.invented > 0)
            said += fmt::format("{}{} misses {} and finds {} that are not there", said.empty() ? "" : "; ",
                                row.way, row.missed, row.invented);
    }
    return fmt::format("{}: {} {}: {}", set.name, asked, set.meaning, said.empty() ? "none missed" : said);
}

std::string cost_sentence(const WaysResult& result, const Named& set) {
    auto rows = result.rows_of(set.name);
    std::sort(rows.begin(), rows.end(), [](const WayRow& a, const WayRow& b) { return a.cost_s < b.cost_s; });
    std::string said;
    for (const WayRow& row : rows)
        said += fmt::format("{}{} {} ({:.1g} m)", said.empty() ? "" : ", ", row.way, seconds_text(row.cost_s),
                            row.error);
    return said;
}

}  // namespace

WaysResult study_queries(const StudySettings& settings, const std::string& scene, std::uint64_t seed,
                         const Surface& surface, const std::vector<SurfaceWays*>& offers,
                         const Deadline& deadline) {
    WaysResult result;
    result.words = {"queries",
                    "questions",
                    "question",
                    "asking",
                    "m",
                    "largest error / m",
                    fmt::format("queries of its surface, {} triangles", surface.faces().size()),
                    kReading,
                    false};
    result.scene = scene;
    result.facts = {{"triangles", surface.faces().size()}, {"size_m", surface.size()}, {"seed", seed}};
    QueryContest contest(surface, seed, offers);
    study_ways(settings, contest, deadline, result);
    for (const Named& set : result.tasks)
        if (!result.rows_of(set.name).empty())
            result.sentences.push_back(
                misses_sentence(result, set) +
                "; a question takes, with its largest error: " + cost_sentence(result, set));
    return result;
}

}  // namespace orbweaver::study
