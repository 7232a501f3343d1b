#include "study/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "study/pareto.hpp"
#include "study/refinement.hpp"

namespace orbweaver::study {

namespace {

constexpr int kRungs = 9;
constexpr int kReferenceRungs = 13;
constexpr double kResolved = 3;   // times the reference's uncertainty: below, an error says nothing
constexpr double kStill = 1e-12;  // m: what moves less stands still
constexpr double kReferenceShare = 0.2;

class AccuracyStudy {
public:
    AccuracyStudy(const StudySettings& settings, const Subject& subject, const Deadline& deadline)
        : settings_(settings), subject_(subject), deadline_(deadline) {
        result_.scene = subject.scene().name;
        result_.table = subject.table();
        result_.frame_s = subject.scene().step;
        result_.duration_s = subject.duration(kUsualDuration);
    }

    AccuracyResult run() {
        stable_reference_ = stable_step(subject_.spec().references[0]);
        find_horizon();
        find_reference();
        run_ladders();
        conclude();
        return std::move(result_);
    }

private:
    double stable_step(const std::string& method) const {
        return study::stable_step(settings_, subject_, method, {}, deadline_);
    }

    // s, half of the stable step; of methods that never are, of the first reference's.
    double coarsest(const std::string& method) const {
        const double stable = std::min(stable_step(method), subject_.scene().step);
        return (stable > 0 ? stable : stable_reference_) / 2;
    }

    std::vector<Rung> reference_rungs(const std::string& method) const {
        return ladder(subject_, method, coarsest(method), kReferenceRungs);
    }

    [[noreturn]] void give_up(const std::string& method, const Trial& trial) const {
        if (deadline_.interrupted()) throw Fault(FaultKind::limit, "interrupted before there was a reference");
        if (trial.ending == Ending::timeout)
            throw Fault(FaultKind::limit,
                        fmt::format("{} did not get through {} in its part of --time {:g}; "
                                    "give more, shorten --duration, or name other --references",
                                    method, seconds_text(result_.duration_s), settings_.time));
        throw Fault(FaultKind::diverged,
                    fmt::format("there is no reference: {} did not get through: {}", method, trial.message));
    }

    void find_horizon() {
        const Rung rung = twin_rung(subject_, [&](const std::string& name) { return coarsest(name); });
        const std::string& method = rung.method;
        TrialPlan plan{subject_.overrides(rung), result_.duration_s};
        const Trial trial = run_trial(settings_, subject_, plan, deadline_);
        if (trial.ending != Ending::done) give_up(method, trial);
        plan.offsets = free_offsets(settings_, subject_, plan.overrides, kDisplacement, deadline_);
        const Trial twin = run_trial(settings_, subject_, plan, deadline_);
        if (twin.ending != Ending::done) give_up(method, twin);
        result_.conditioning = judge(trial.motion, twin.motion);
        result_.conditioning.rung = rung;
        const std::size_t first = result_.conditioning.statistics_row();
        const std::size_t busiest = busiest_particle(trial.motion, first);
        result_.twin = compare(measure(twin.motion, busiest, first), measure(trial.motion, busiest, first));
        result_.particles = trial.motion.particles;
    }

    Refined refined(const std::string& method) const {
        const auto rungs = reference_rungs(method);
        auto found = refine(settings_, subject_, rungs, result_.duration_s, result_.conditioning.horizon_rows,
                            deadline_.share(kReferenceShare));
        if (found) return std::move(*found);
        Trial none;
        none.ending = Ending::timeout;
        give_up(method, none);
    }

    void find_reference() {
        const auto& methods = subject_.spec().references;
        Refined first = refined(methods[0]);
        const Refined second = refined(methods[1]);
        const std::size_t rows = result_.conditioning.horizon_rows;
        result_.reference = first.rung;
        result_.second = second.rung;
        result_.second_is_a_limit = second.limit.has_value();
        result_.uncertainty_m = distance(first.motion, second.limit ? *second.limit : second.motion, rows);
        reference_ = std::move(first.motion);
        result_.displacement_m = largest_displacement(reference_);
        const std::size_t begin = result_.conditioning.statistics_row();
        busiest_ = busiest_particle(reference_, begin);
        result_.statistics = measure(reference_, busiest_, begin);
    }

    void run_ladders() {
        const auto& methods = subject_.methods();
        Progress progress("accuracy", 0, methods.size() * kRungs, 0, settings_.run.quiet, "rungs");
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const double stable = std::max(stable_step(methods[i]), stable_reference_);
            const double first = std::min(4 * stable, subject_.scene().step);
            const Deadline share = deadline_.share(1 / static_cast<double>(methods.size() - i));
            run_ladder(ladder(subject_, methods[i], first, kRungs), share,
                       [&](std::size_t k) { progress.update(i * kRungs + k); });
        }
    }

    template <class Done>
    void run_ladder(const std::vector<Rung>& rungs, const Deadline& share, Done&& done) {
        const double whole = share.left();
        double elapsed = 0;
        for (std::size_t k = 0; k < rungs.size(); ++k) {
            if (2 * elapsed > share.left() || !run_rung(rungs[k], share, whole, elapsed))
                return leave_out(rungs[k].method, rungs.size() - k, rungs.size());
            done(k + 1);
        }
        if (!refusal_.empty())
            result_.sentences.push_back(
                fmt::format("{}: refused down to its finest rung: {}", rungs.back().method, refusal_));
    }

    void leave_out(const std::string& method, std::size_t count, std::size_t rungs) {
        const std::string which = count == rungs ? fmt::format("all of its {} rungs", rungs)
                                  : count == 1   ? fmt::format("the finest of its {} rungs", rungs)
                                                 : fmt::format("the {} finest of its {} rungs", count, rungs);
        result_.sentences.push_back(fmt::format("{}: left out {}: {}", method, deadline_.why_passed(), which));
    }

    // Repeats take at most a tenth of the method's time: what runs long varies little.
    bool run_rung(const Rung& rung, const Deadline& share, double whole, double& elapsed) {
        const TrialPlan plan{subject_.overrides(rung), result_.duration_s};
        const Trial trial = run_trial(settings_, subject_, plan, share);
        if (trial.ending == Ending::timeout) return false;
        refusal_ = trial.ending == Ending::refused ? trial.message : "";
        elapsed = trial.elapsed_s;
        std::vector<double> walls{trial.wall_s};
        for (int i = 1; i < settings_.repeats && trial.ending == Ending::done; ++i) {
            if ((i + 1) * elapsed > 0.1 * whole) break;
            const Trial again = run_trial(settings_, subject_, plan, share);
            if (again.ending == Ending::timeout) break;
            walls.push_back(again.wall_s);
        }
        add_row(rung, trial, std::move(walls));
        return true;
    }

    void add_row(const Rung& rung, const Trial& trial, std::vector<double> walls) {
        AccuracyRow row{rung, std::nullopt, 0, trial.steps, to_string(trial.ending), std::nullopt};
        row.runs = static_cast<int>(walls.size());
        row.wall_s = median(std::move(walls));
        if (trial.ending == Ending::done) {
            row.error_m = distance(reference_, trial.motion, result_.conditioning.horizon_rows);
            row.deviation = compare(measure(trial.motion, busiest_, result_.conditioning.statistics_row()),
                                    result_.statistics);
            if (*row.error_m < kResolved * result_.uncertainty_m) row.outcome = "unresolved";
        }
        result_.rows.push_back(std::move(row));
    }

    void conclude() {
        std::vector<CostError> resolved;  // for the front: what is measured
        std::vector<CostError> certain;   // for promises: what is measured and the doubt in it
        for (const AccuracyRow& row : result_.rows) {
            const double error = row.error_m.value_or(HUGE_VAL);
            resolved.push_back({row.wall_s, row.outcome == "done" ? error : HUGE_VAL});
            certain.push_back({row.wall_s, error + result_.uncertainty_m});
        }
        result_.front = pareto_front(resolved);
        std::vector<std::string> found;
        if (result_.displacement_m <= kResolved * result_.uncertainty_m)
            found.push_back(
                result_.displacement_m <= kStill
                    ? "nothing moves in this scene: only runs that break its rest have an error"
                    : fmt::format("the references are {:.2g} m apart, and the motion reaches {:.2g} m: no "
                                  "error can be told from doubt here",
                                  result_.uncertainty_m, result_.displacement_m));
        for (const int decade : decades(resolved)) {
            if (std::pow(10, decade - 1) > result_.displacement_m) continue;  // to stand still errs less
            if (const auto best = cheapest_within(certain, std::pow(10, decade)))
                found.push_back(fmt::format("within 1e{} m: {}, {:.2g} s", decade,
                                            to_string(result_.rows[*best].rung), result_.rows[*best].wall_s));
        }
        if (!result_.conditioning.whole) found.push_back(beyond_the_horizon());
        result_.sentences.insert(result_.sentences.begin(), found.begin(), found.end());
    }

    // A twin's statistics are one sample of what chance does, so three times that is still chance.
    bool is_chance(const Deviation& deviation) const {
        const Deviation& twin = result_.twin;
        const bool energy = std::isnan(twin.energy) || deviation.energy <= kResolved * twin.energy;
        return energy && deviation.shape_m <= kResolved * twin.shape_m &&
               deviation.spectrum <= kResolved * twin.spectrum;
    }

    std::string beyond_the_horizon() const {
        const AccuracyRow* best = nullptr;
        int count = 0;
        for (const AccuracyRow& row : result_.rows) {
            if (!row.deviation || !is_chance(*row.deviation)) continue;
            ++count;
            if (best == nullptr || row.wall_s < best->wall_s) best = &row;
        }
        return fmt::format(
            "beyond {}: chance alone (the twin) changes {}the mean shape by {:.2g} m and the spectrum by "
            "{:.2g}; "
            "{} of {} runs differ from the reference by at most three times that{}",
            seconds_text(result_.conditioning.horizon_s),
            std::isnan(result_.twin.energy) ? ""
                                            : fmt::format("the mean energy by {:.2g}, ", result_.twin.energy),
            result_.twin.shape_m, result_.twin.spectrum, count, result_.rows.size(),
            best == nullptr ? ""
                            : fmt::format(", the cheapest {}, {:.2g} s", to_string(best->rung), best->wall_s));
    }

    const StudySettings& settings_;
    const Subject& subject_;
    const Deadline& deadline_;
    AccuracyResult result_;
    double stable_reference_ = 0;  // s
    Motion reference_;
    std::size_t busiest_ = 0;
    std::string refusal_;  // of the rung run last; empty: it was not refused
};

}  // namespace

AccuracyResult study_accuracy(const StudySettings& settings, const Subject& subject, const Deadline& deadline) {
    return AccuracyStudy(settings, subject, deadline).run();
}

}  // namespace orbweaver::study
