#include "study/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <numeric>
#include <regex>

#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "study/conditioning.hpp"
#include "study/trial.hpp"

namespace orbweaver::study {

namespace {

constexpr double kReferenceShare = 0.3;

/// What the cells of the same physics are compared with.
struct Reference {
    const std::vector<Vec3>* nudges = nullptr;  ///< m; null: there was no time for it
    std::optional<double> speed;                ///< m/s, rms; nothing when it did not get through
};

/// What is left of a sentence when its numbers and their units' prefixes are not looked at.
std::string without_numbers(const std::string& sentence) {
    static const std::regex number("[0-9][0-9.]*(e[+-]?[0-9]+)?( [num]?s\\b)?");
    return std::regex_replace(sentence, number, "#");
}

class StabilityStudy {
public:
    StabilityStudy(const StudySettings& settings, const Subject& subject, const Deadline& deadline)
        : settings_(settings), subject_(subject), deadline_(deadline) {
        result_.scene = subject.scene().name;
        result_.table = subject.table();
        result_.duration_s = subject.duration(kUsualCellDuration);
    }

    StabilityResult run(const std::vector<AxisText>& axes) {
        result_.axes = choose_axes(settings_, subject_, axes, deadline_);
        result_.asked_step_s = asked_step(subject_, plan_scene(settings_.run).plan);
        methods_ = studied_methods();
        run_references();
        run_maps();
        check_findings();
        if (deadline_.interrupted()) result_.sentences.emplace_back("interrupted: what was not run is unknown");
        return std::move(result_);
    }

private:
    // The last word on an option counts: what an axis varies overrides what is usual.
    std::vector<std::string> cell_overrides(const std::string& method, std::size_t cell) const {
        const MapAxes& axes = result_.axes;
        return {subject_.assign(subject_.spec().method, method),
                subject_.assign(subject_.spec().on_unstable, "as_asked"), axes.x.assignment(axes.column(cell)),
                axes.y.assignment(axes.row(cell))};
    }

    double stable_step(const std::string& method, const std::vector<std::string>& changes) const {
        return study::stable_step(settings_, subject_, method, changes, deadline_);
    }

    // A quarter of the stable step: at all of it, explicit methods damp the fastest modes.
    Rung reference_rung(const std::vector<std::string>& changes) const {
        const std::string& method = subject_.spec().references[0];
        const double stable = stable_step(method, changes);
        return subject_.rung_within(method, stable > 0 ? stable / 4 : subject_.scene().step);
    }

    // The same physics by the method of reference.
    Reference reference_of(const std::vector<std::string>& changes, const Deadline& share) {
        Reference found;
        if (share.passed()) return found;
        std::vector<std::string> overrides = subject_.overrides(reference_rung(changes));
        overrides.push_back(subject_.assign(subject_.spec().on_unstable, "substep"));
        overrides.insert(overrides.end(), changes.begin(), changes.end());
        found.nudges = shared(free_offsets(settings_, subject_, overrides, kNudge, share));
        const Trial trial =
            run_trial(settings_, subject_, {overrides, result_.duration_s, *found.nudges}, share);
        if (trial.ending == Ending::timeout) found.nudges = nullptr;
        if (trial.ending == Ending::done) found.speed = rms_speed(trial.motion);
        return found;
    }

    // Physics differ in their particles only when an axis varies what is built.
    const std::vector<Vec3>* shared(std::vector<Vec3> nudges) {
        const auto known = std::find(nudges_.begin(), nudges_.end(), nudges);
        return known != nudges_.end() ? &*known : &nudges_.emplace_back(std::move(nudges));
    }

    void run_references() {
        const Deadline share = deadline_.share(kReferenceShare);
        Progress progress("references", 0, result_.axes.cells(), 0, settings_.run.quiet, "cells");
        for (std::size_t cell = 0; cell < result_.axes.cells(); ++cell) {
            const auto [found, is_new] = references_.emplace(result_.axes.physics(cell), Reference{});
            if (is_new) found->second = reference_of(found->first, share);
            progress.update(cell + 1);
        }
    }

    static CellClass judge(const Trial& trial, const std::optional<double>& reference) {
        switch (trial.ending) {
            case Ending::diverged:
                return CellClass::diverged;
            case Ending::refused:
            case Ending::limit:
                return CellClass::refused;
            case Ending::timeout:
                return CellClass::unknown;
            default:
                break;
        }
        if (!reference) return CellClass::unknown;
        // What the nudge alone does between two frames is no motion of the scene's.
        const double floor = 4 * kNudge / trial.motion.frame_s;
        const double speed = std::max(floor, rms_speed(trial.motion));
        const double expected = std::max(floor, *reference);
        return speed <= kSpeedFactor * expected && expected <= kSpeedFactor * speed ? CellClass::stable
                                                                                    : CellClass::degraded;
    }

    /// From long steps to short ones.
    std::vector<std::size_t> order() const {
        std::vector<std::size_t> all(result_.axes.cells());
        std::iota(all.begin(), all.end(), std::size_t{0});
        const MapAxes& axes = result_.axes;
        std::stable_sort(all.begin(), all.end(),
                         [&](std::size_t a, std::size_t b) { return axes.step_of(a) > axes.step_of(b); });
        return all;
    }

    bool varies_tolerance() const {
        const std::string& tolerance = subject_.spec().tolerance;
        if (tolerance.empty()) return false;
        const std::string path = subject_.table() + "." + tolerance;
        return result_.axes.x.path == path || result_.axes.y.path == path;
    }

    std::vector<std::string> studied_methods() const {
        std::vector<std::string> all;
        for (const std::string& method : subject_.methods()) {
            const bool lacks_step = result_.axes.step_axis >= 0 && !subject_.by_step(method);
            const bool lacks_tolerance = varies_tolerance() && !subject_.by_tolerance(method);
            if (!lacks_step && !lacks_tolerance) all.push_back(method);
        }
        if (all.empty())
            throw Fault(
                FaultKind::invalid,
                "the methods asked for have no step or tolerance that an axis could vary; name two other "
                "axes, or other methods");
        return all;
    }

    void run_maps() {
        Progress progress("stability", 0, methods_.size() * result_.axes.cells(), 0, settings_.run.quiet,
                          "cells");
        for (std::size_t m = 0; m < methods_.size(); ++m) {
            StabilityMap map{methods_[m], {}, {}, taken_step(methods_[m]), {}};
            advise(map);
            const Deadline share = deadline_.share(1 / static_cast<double>(methods_.size() - m));
            run_map(map, share, [&](std::size_t done) { progress.update(m * result_.axes.cells() + done); });
            result_.sentences.push_back(summary(map));
            say_refusals(map);
            result_.maps.push_back(std::move(map));
        }
    }

    template <class Done>
    void run_map(StabilityMap& map, const Deadline& share, Done&& done) {
        map.cells.assign(result_.axes.cells(), CellClass::unknown);
        map.reasons.assign(result_.axes.cells(), {});
        std::size_t count = 0;
        for (const std::size_t cell : order()) {
            if (share.passed()) return;
            const Reference& reference = references_.at(result_.axes.physics(cell));
            if (reference.nudges != nullptr) run_cell(map, cell, reference, share);
            done(++count);
        }
    }

    void run_cell(StabilityMap& map, std::size_t cell, const Reference& reference,
                  const Deadline& share) const {
        const TrialPlan plan{cell_overrides(map.method, cell), result_.duration_s, *reference.nudges};
        const Trial trial = run_trial(settings_, subject_, plan, share);
        map.cells[cell] = judge(trial, reference.speed);
        if (map.cells[cell] == CellClass::refused) map.reasons[cell] = trial.message;
    }

    /// Each reason once, with the first cell that has it: those that differ in numbers only are one.
    void say_refusals(const StabilityMap& map) {
        struct Refusals {
            std::size_t first = 0;
            std::size_t count = 0;
        };
        std::map<std::string, Refusals> found;
        for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
            if (map.cells[cell] != CellClass::refused) continue;
            const auto [it, is_new] = found.emplace(without_numbers(map.reasons[cell]), Refusals{cell, 0});
            ++it->second.count;
        }
        const MapAxes& axes = result_.axes;
        for (const auto& [alike, refusals] : found)
            result_.sentences.push_back(fmt::format(
                "{}: refused in {} {}, as at {} and {}: {}", map.method, refusals.count,
                refusals.count == 1 ? "cell" : "cells", axes.x.assignment(axes.column(refusals.first)),
                axes.y.assignment(axes.row(refusals.first)), map.reasons[refusals.first]));
    }

    void advise(StabilityMap& map) const {
        const MapAxis& other = result_.axes.other();
        if (result_.axes.step_axis < 0) return;
        for (std::size_t i = 0; i < other.values.size(); ++i) {
            std::vector<std::string> changes;
            if (other.physical) changes.push_back(other.assignment(i));
            map.advised_s.push_back(stable_step(map.method, changes));
        }
    }

    std::optional<double> taken_step(const std::string& method) const {
        const double frame = subject_.scene().step;
        const Trial trial = run_trial(settings_, subject_,
                                      {{subject_.assign(subject_.spec().method, method)}, frame}, deadline_);
        if (trial.ending != Ending::done || trial.steps == 0) return std::nullopt;
        return frame / static_cast<double>(trial.steps);
    }

    void check_findings() const {
        const auto all_unknown = [](const StabilityMap& map) {
            return std::all_of(map.cells.begin(), map.cells.end(),
                               [](CellClass kind) { return kind == CellClass::unknown; });
        };
        if (!deadline_.passed() || !std::all_of(result_.maps.begin(), result_.maps.end(), all_unknown)) return;
        if (deadline_.interrupted()) throw Fault(FaultKind::limit, "interrupted before a cell was run");
        throw Fault(FaultKind::limit,
                    fmt::format("no cell was run in --time {:g}; give more, or vary less", settings_.time));
    }

    std::string summary(const StabilityMap& map) const {
        std::string text = map.method + ":";
        for (const CellClass kind : {CellClass::stable, CellClass::degraded, CellClass::diverged,
                                     CellClass::refused, CellClass::unknown}) {
            const auto count = std::count(map.cells.begin(), map.cells.end(), kind);
            if (count > 0) text += fmt::format(" {} {},", count, to_string(kind));
        }
        text.pop_back();
        return text + fmt::format(" of {} cells", result_.axes.cells());
    }

    const StudySettings& settings_;
    const Subject& subject_;
    const Deadline& deadline_;
    StabilityResult result_;
    std::vector<std::string> methods_;
    std::list<std::vector<Vec3>> nudges_;                       // m; references point into it
    std::map<std::vector<std::string>, Reference> references_;  // by physics
};

}  // namespace

const char* to_string(CellClass kind) noexcept {
    static constexpr const char* names[] = {"stable", "degraded", "diverged", "refused", "unknown"};
    return names[static_cast<std::size_t>(kind)];
}

StabilityResult study_stability(const StudySettings& settings, const Subject& subject,
                                const std::vector<AxisText>& axes, const Deadline& deadline) {
    return StabilityStudy(settings, subject, deadline).run(axes);
}

}  // namespace orbweaver::study
