#include "study/queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "scene/nearest_name.hpp"
#include "study/query_questions.hpp"
#include "study/statistics.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

namespace {

constexpr std::size_t kMostQuestions = 2000;
constexpr std::size_t kFewestQuestions = 100;
constexpr std::size_t kReferenceTriangles = 200'000'000;  // asked by the reference for each kind: about 2 s
constexpr double kPass = 5e-3;                            // s, that a timed pass takes at least

/// One way of one module.
struct Offer {
    SurfaceWays* of;
    std::size_t number;
    const SurfaceWays::Way& way() const { return of->ways()[number]; }
};

std::vector<Offer> chosen(const std::vector<SurfaceWays*>& offers, const std::vector<std::string>& wanted) {
    std::vector<Offer> all;
    std::vector<std::string> names;
    for (SurfaceWays* each : offers)
        for (std::size_t i = 0; i < each->ways().size(); ++i) {
            all.push_back({each, i});
            names.emplace_back(each->ways()[i].name);
        }
    for (const std::string& name : wanted)
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            const std::string nearest = nearest_name(name, names);
            throw Fault(
                FaultKind::invalid,
                fmt::format("--method {}: there is no such way of asking; expected {}{}", name,
                            join_names(names), nearest.empty() ? "" : "; did you mean " + nearest + "?"));
        }
    if (!wanted.empty())
        std::erase_if(all, [&](const Offer& offer) {
            return std::find(wanted.begin(), wanted.end(), offer.way().name) == wanted.end();
        });
    return all;
}

class QueryStudy {
public:
    QueryStudy(const StudySettings& settings, const Surface& surface, std::vector<Offer> ways,
               const Deadline& deadline, QueryResult& result)
        : settings_(settings),
          surface_(surface),
          ways_(std::move(ways)),
          deadline_(deadline),
          result_(result) {}

    void run() {
        const std::size_t count =
            std::clamp(kReferenceTriangles / surface_.faces().size(), kFewestQuestions, kMostQuestions);
        const auto sets = make_questions(surface_, result_.seed, count);
        for (const QuestionSet& set : sets) result_.sets.push_back({set.name, set.meaning});
        Progress progress("queries", 0, sets.size() * ways_.size(), 0, settings_.run.quiet, "ways");
        std::size_t done = 0;
        for (const QuestionSet& set : sets)
            for (const Offer& offer : ways_) {
                if (set.suits(offer.way().finds)) ask(set, offer);
                progress.update(++done);
            }
    }

private:
    void ask(const QuestionSet& set, const Offer& offer) {
        if (deadline_.passed()) {
            result_.sentences.push_back(
                fmt::format("{} by {}: left out {}", set.name, offer.way().name,
                            deadline_.interrupted() ? "when interrupted" : "for lack of time"));
            return;
        }
        std::vector<SurfaceHit> hits(set.questions.size());
        std::vector<double> passes(static_cast<std::size_t>(settings_.repeats));
        for (double& pass : passes) pass = timed(set, offer, hits);
        QueryRow row{set.name, offer.way().name, set.questions.size(), 0, 0, 0, 0, median(std::move(passes))};
        judge(set, offer, hits, row);
        result_.rows.push_back(std::move(row));
    }

    /// s a question, asked as often as a clock needs.
    double timed(const QuestionSet& set, const Offer& offer, std::vector<SurfaceHit>& hits) const {
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        double elapsed = 0;
        int times = 0;
        while (elapsed < kPass) {
            offer.of->answer(offer.number, set.questions, hits);
            elapsed = std::chrono::duration<double>(Clock::now() - start).count();
            ++times;
        }
        return elapsed / times / static_cast<double>(set.questions.size());
    }

    void judge(const QuestionSet& set, const Offer& offer, const std::vector<SurfaceHit>& hits,
               QueryRow& row) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const QueryTruth& truth = set.truths[i];
            if (hits[i].answer == Answer::failed)
                throw Fault(FaultKind::limit, fmt::format("{}: no memory for what it needs; use a coarser mesh",
                                                          offer.way().name));
            if (hits[i].answer != Answer::found) {
                row.missed += truth.certain;
                continue;
            }
            row.invented += truth.places.empty();
            double error = HUGE_VAL;
            const Vec3 found = surface_.position(hits[i].at);
            for (const Vec3& place : truth.places) error = std::min(error, distance(place, found));
            if (!truth.places.empty()) errors.push_back(error);
        }
        if (errors.empty()) return;
        row.error_m = *std::max_element(errors.begin(), errors.end());
        row.median_error_m = median(std::move(errors));
    }

    const StudySettings& settings_;
    const Surface& surface_;
    std::vector<Offer> ways_;
    const Deadline& deadline_;
    QueryResult& result_;
};

std::string misses_sentence(const QueryResult& result, const QueryResult::Named& set) {
    std::string said;
    std::size_t asked = 0;
    for (const QueryRow& row : result.rows_of(set.name)) {
        asked = row.asked;
        if (row.missed + row.invented > 0)
            said += fmt::format("{}{} misses {} and finds {} that are not there", said.empty() ? "" : "; ",
                                row.way, row.missed, row.invented);
    }
    return fmt::format("{}: {} {}: {}", set.name, asked, set.meaning, said.empty() ? "none missed" : said);
}

std::string cost_sentence(const QueryResult& result, const QueryResult::Named& set) {
    auto rows = result.rows_of(set.name);
    std::sort(rows.begin(), rows.end(),
              [](const QueryRow& a, const QueryRow& b) { return a.cost_s < b.cost_s; });
    std::string said;
    for (const QueryRow& row : rows)
        said += fmt::format("{}{} {} ({:.1g} m)", said.empty() ? "" : ", ", row.way, seconds_text(row.cost_s),
                            row.error_m);
    return said;
}

}  // namespace

std::vector<QueryRow> QueryResult::rows_of(const std::string& questions) const {
    std::vector<QueryRow> found;
    for (const QueryRow& row : rows)
        if (row.questions == questions) found.push_back(row);
    return found;
}

QueryResult study_queries(const StudySettings& settings, const std::string& scene, std::uint64_t seed,
                          const Surface& surface, const std::vector<SurfaceWays*>& offers,
                          const Deadline& deadline) {
    QueryResult result;
    result.scene = scene;
    result.triangles = surface.faces().size();
    result.size_m = surface.size();
    result.seed = seed;
    auto ways = chosen(offers, settings.methods);
    for (const Offer& offer : ways) result.ways.push_back({offer.way().name, offer.way().meaning});
    QueryStudy(settings, surface, std::move(ways), deadline, result).run();
    for (const auto& set : result.sets)
        if (!result.rows_of(set.name).empty())
            result.sentences.push_back(
                misses_sentence(result, set) +
                "; a question takes, with its largest error: " + cost_sentence(result, set));
    return result;
}

}  // namespace orbweaver::study
