#include "study/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "study/conditioning.hpp"
#include "study/trial.hpp"

namespace orbweaver::study {

namespace {

constexpr double kReferenceShare = 0.3;

std::string assignment(const MapAxis& axis, double value) { return fmt::format("{}={}", axis.path, value); }

class StabilityStudy {
public:
    StabilityStudy(const StudySettings& settings, const Subject& subject, const Deadline& deadline)
        : settings_(settings), subject_(subject), deadline_(deadline) {
        result_.scene = subject.scene().name;
        result_.table = subject.table();
        result_.duration_s = subject.duration(kUsualCellDuration);
    }

    StabilityResult run(const std::vector<AxisText>& axes) {
        choose_axes(axes);
        nudges_ = free_offsets(settings_, subject_, subject_.rung(subject_.spec().references[0], 64), kNudge,
                               deadline_);
        run_references();
        run_maps();
        return std::move(result_);
    }

private:
    void choose_axes(const std::vector<AxisText>& axes) {
        const PlannedScene planned = plan_scene(settings_.run);
        const auto resolved = [&](std::size_t i) {
            return resolve_axis(i < axes.size() ? axes[i] : default_axis(axes, i), planned.plan);
        };
        result_.x = resolved(0);
        result_.y = resolved(1);
        for (const MapAxis* axis : {&result_.x, &result_.y}) {
            check_ends(*axis);
            if (axis->table == subject_.table() && axis->option == subject_.spec().step)
                result_.step_axis = axis == &result_.x ? 0 : 1;
        }
        if (result_.step_axis >= 0) snap_steps(result_.step_axis == 0 ? result_.x : result_.y);
    }

    // A frame is cut into equal steps: other steps than those that divide it would be taken shorter than asked.
    void snap_steps(MapAxis& axis) const {
        const double frame = subject_.scene().step;
        for (double& step : axis.values) step = frame / std::max(1.0, std::round(frame / step));
        axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
        if (axis.values.size() < 2)
            throw Fault(FaultKind::invalid,
                        fmt::format("--axis {}: these steps come to one step of {}; expected two or more that "
                                    "divide a frame of {}",
                                    axis.path, seconds_text(axis.values[0]), seconds_text(frame)));
    }

    // The step around what the scene's web bears, and the module's own axis; whichever is not given yet.
    AxisText default_axis(const std::vector<AxisText>& given, std::size_t index) const {
        const std::string step = subject_.table() + "." + subject_.spec().step;
        const std::string other = subject_.table() + "." + subject_.spec().axis;
        const bool has_step = !given.empty() && given[0].path == step;
        if (index == 1 && !has_step && !given.empty()) return step_axis(step);
        if (index == 0) return step_axis(step);
        return {other, {0.01, {}, false}, {100, {}, false}, 9, true};
    }

    AxisText step_axis(const std::string& path) const {
        const double frame = subject_.scene().step;
        const double stable = stable_step(subject_.spec().references[0], {});
        const double middle = std::isfinite(stable) && stable > 0 ? std::min(stable, frame) : frame;
        return {path, {middle / 16, {}, false}, {std::min(32 * middle, frame), {}, false}, 13, true};
    }

    void check_ends(const MapAxis& axis) const {
        for (const double end : {axis.values.front(), axis.values.back()}) {
            RunSettings run = settings_.run;
            run.overrides.push_back(assignment(axis, end));
            const PlannedScene planned = plan_scene(run);
            if (!planned.plan.faults.empty())
                throw Fault(FaultKind::invalid,
                            fmt::format("--axis {}: {}", axis.path, all_sentences(planned.plan.faults)));
        }
    }

    std::vector<std::string> method_only(const std::string& method, const char* on_unstable) const {
        return {subject_.assign(subject_.spec().method, method),
                subject_.assign(subject_.spec().on_unstable, on_unstable)};
    }

    double stable_step(const std::string& method, const std::vector<std::string>& physics) const {
        std::vector<std::string> overrides = subject_.overrides(subject_.rung(method, 1));
        overrides.insert(overrides.end(), physics.begin(), physics.end());
        return run_trial(settings_, subject_, {overrides, 0}, deadline_).stable_step_s;
    }

    std::size_t columns() const { return result_.x.values.size(); }
    std::size_t cells() const { return columns() * result_.y.values.size(); }

    /// What a cell changes of the scene itself; the method's step is none of it.
    std::vector<std::string> physics(std::size_t cell) const {
        std::vector<std::string> all;
        if (result_.step_axis != 0) all.push_back(assignment(result_.x, result_.x.values[cell % columns()]));
        if (result_.step_axis != 1) all.push_back(assignment(result_.y, result_.y.values[cell / columns()]));
        return all;
    }

    std::vector<std::string> cell_overrides(const std::string& method, std::size_t cell) const {
        std::vector<std::string> all = method_only(method, "as_asked");
        all.push_back(assignment(result_.x, result_.x.values[cell % columns()]));
        all.push_back(assignment(result_.y, result_.y.values[cell / columns()]));
        return all;
    }

    // The same physics by the method of reference, at a quarter of the stable step: at all of it, explicit
    // methods damp the fastest modes.
    std::optional<double> reference_speed(const std::vector<std::string>& changes,
                                          const Deadline& share) const {
        const std::string& method = subject_.spec().references[0];
        const double stable = stable_step(method, changes);
        const double asked = std::min(subject_.scene().step, stable > 0 ? stable / 4 : HUGE_VAL);
        std::vector<std::string> overrides = method_only(method, "substep");
        overrides.push_back(subject_.assign(subject_.spec().step, asked));
        overrides.insert(overrides.end(), changes.begin(), changes.end());
        const Trial trial = run_trial(settings_, subject_, {overrides, result_.duration_s, nudges_}, share);
        return trial.ending == Ending::done ? std::optional(rms_speed(trial.motion)) : std::nullopt;
    }

    void run_references() {
        const Deadline share = deadline_.share(kReferenceShare);
        Progress progress("references", 0, cells(), 0, settings_.run.quiet, "cells");
        for (std::size_t cell = 0; cell < cells(); ++cell) {
            const auto [found, is_new] = references_.emplace(physics(cell), std::nullopt);
            if (is_new) found->second = reference_speed(found->first, share);
            progress.update(cell + 1);
        }
    }

    CellClass judge(const Trial& trial, const std::optional<double>& reference) const {
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
        std::vector<std::size_t> all(cells());
        std::iota(all.begin(), all.end(), std::size_t{0});
        const auto length = [&](std::size_t cell) {
            return result_.step_axis == 0 ? cell % columns() : result_.step_axis == 1 ? cell / columns() : 0;
        };
        std::stable_sort(all.begin(), all.end(),
                         [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
        return all;
    }

    std::vector<std::string> studied_methods() const {
        std::vector<std::string> all;
        for (const std::string& method : subject_.methods()) {
            const bool skipped = result_.step_axis >= 0 && subject_.by_tolerance(method);
            if (!skipped) all.push_back(method);
        }
        return all;
    }

    void run_maps() {
        const auto methods = studied_methods();
        if (methods.empty())
            throw Fault(FaultKind::invalid,
                        "the methods asked for have no step that an axis could vary; name two "
                        "other axes, or other methods");
        Progress progress("stability", 0, methods.size() * cells(), 0, settings_.run.quiet, "cells");
        for (std::size_t m = 0; m < methods.size(); ++m) {
            StabilityMap map{methods[m], {}, {}, own_step(methods[m])};
            advise(map);
            const Deadline share = deadline_.share(1 / static_cast<double>(methods.size() - m));
            run_map(map, share, [&](std::size_t done) { progress.update(m * cells() + done); });
            result_.sentences.push_back(summary(map));
            result_.maps.push_back(std::move(map));
        }
    }

    template <class Done>
    void run_map(StabilityMap& map, const Deadline& share, Done&& done) {
        map.cells.assign(cells(), CellClass::unknown);
        std::size_t count = 0;
        for (const std::size_t cell : order()) {
            if (share.passed()) return;
            const Trial trial = run_trial(
                settings_, subject_, {cell_overrides(map.method, cell), result_.duration_s, nudges_}, share);
            map.cells[cell] = judge(trial, references_.at(physics(cell)));
            done(++count);
        }
    }

    void advise(StabilityMap& map) const {
        if (result_.step_axis < 0) return;
        const MapAxis& other = result_.step_axis == 0 ? result_.y : result_.x;
        for (const double value : other.values)
            map.advised_s.push_back(stable_step(map.method, {assignment(other, value)}));
    }

    std::optional<double> own_step(const std::string& method) const {
        const Trial trial =
            run_trial(settings_, subject_, {method_only(method, "substep"), subject_.scene().step}, deadline_);
        if (trial.ending != Ending::done || trial.steps == 0) return std::nullopt;
        return subject_.scene().step / static_cast<double>(trial.steps);
    }

    std::string summary(const StabilityMap& map) const {
        std::string text = map.method + ":";
        for (const CellClass kind : {CellClass::stable, CellClass::degraded, CellClass::diverged,
                                     CellClass::refused, CellClass::unknown}) {
            const auto count = std::count(map.cells.begin(), map.cells.end(), kind);
            if (count > 0) text += fmt::format(" {} {},", count, to_string(kind));
        }
        text.pop_back();
        return text + fmt::format(" of {} cells", cells());
    }

    const StudySettings& settings_;
    const Subject& subject_;
    const Deadline& deadline_;
    StabilityResult result_;
    std::vector<Vec3> nudges_;
    std::map<std::vector<std::string>, std::optional<double>> references_;  // rms speed, m/s, by physics
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
