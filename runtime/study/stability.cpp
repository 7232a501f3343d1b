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
        nudges_ = free_offsets(settings_, subject_, reference_rung({}), kNudge, deadline_);
        run_references();
        run_maps();
        return std::move(result_);
    }

private:
    std::vector<std::string> method_only(const std::string& method, const char* on_unstable) const {
        return {subject_.assign(subject_.spec().method, method),
                subject_.assign(subject_.spec().on_unstable, on_unstable)};
    }

    std::vector<std::string> cell_overrides(const std::string& method, std::size_t cell) const {
        std::vector<std::string> all = method_only(method, "as_asked");
        all.push_back(assignment(result_.axes.x, result_.axes.x_of(cell)));
        all.push_back(assignment(result_.axes.y, result_.axes.y_of(cell)));
        return all;
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
    std::optional<double> reference_speed(const std::vector<std::string>& changes,
                                          const Deadline& share) const {
        std::vector<std::string> overrides = subject_.overrides(reference_rung(changes));
        overrides.push_back(subject_.assign(subject_.spec().on_unstable, "substep"));
        overrides.insert(overrides.end(), changes.begin(), changes.end());
        const Trial trial = run_trial(settings_, subject_, {overrides, result_.duration_s, nudges_}, share);
        return trial.ending == Ending::done ? std::optional(rms_speed(trial.motion)) : std::nullopt;
    }

    void run_references() {
        const Deadline share = deadline_.share(kReferenceShare);
        Progress progress("references", 0, result_.axes.cells(), 0, settings_.run.quiet, "cells");
        for (std::size_t cell = 0; cell < result_.axes.cells(); ++cell) {
            const auto [found, is_new] = references_.emplace(result_.axes.physics(cell), std::nullopt);
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
        std::vector<std::size_t> all(result_.axes.cells());
        std::iota(all.begin(), all.end(), std::size_t{0});
        const auto length = [&](std::size_t cell) {
            const MapAxes& axes = result_.axes;
            return axes.step_axis == 0 ? axes.x_of(cell) : axes.step_axis == 1 ? axes.y_of(cell) : 0.0;
        };
        std::stable_sort(all.begin(), all.end(),
                         [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
        return all;
    }

    std::vector<std::string> studied_methods() const {
        std::vector<std::string> all;
        for (const std::string& method : subject_.methods()) {
            const bool skipped = result_.axes.step_axis >= 0 && !subject_.by_step(method);
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
        Progress progress("stability", 0, methods.size() * result_.axes.cells(), 0, settings_.run.quiet,
                          "cells");
        for (std::size_t m = 0; m < methods.size(); ++m) {
            StabilityMap map{methods[m], {}, {}, own_step(methods[m])};
            advise(map);
            const Deadline share = deadline_.share(1 / static_cast<double>(methods.size() - m));
            run_map(map, share, [&](std::size_t done) { progress.update(m * result_.axes.cells() + done); });
            result_.sentences.push_back(summary(map));
            result_.maps.push_back(std::move(map));
        }
    }

    template <class Done>
    void run_map(StabilityMap& map, const Deadline& share, Done&& done) {
        map.cells.assign(result_.axes.cells(), CellClass::unknown);
        std::size_t count = 0;
        for (const std::size_t cell : order()) {
            if (share.passed()) return;
            const Trial trial = run_trial(
                settings_, subject_, {cell_overrides(map.method, cell), result_.duration_s, nudges_}, share);
            map.cells[cell] = judge(trial, references_.at(result_.axes.physics(cell)));
            done(++count);
        }
    }

    void advise(StabilityMap& map) const {
        const MapAxis& other = result_.axes.other();
        if (result_.axes.step_axis < 0) return;
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
        return text + fmt::format(" of {} cells", result_.axes.cells());
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
