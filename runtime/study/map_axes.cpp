#include "study/map_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"

namespace orbweaver::study {

namespace {

AxisText default_step(const StudySettings& settings, const Subject& subject, const Deadline& deadline) {
    const double frame = subject.scene().step;
    const double stable = stable_step(settings, subject, subject.spec().references[0], {}, deadline);
    const double middle = stable > 0 ? std::min(stable, frame) : frame;
    return {subject.table() + "." + subject.spec().step,
            {middle / 16, {}, false},
            {std::min(32 * middle, frame), {}, false},
            13,
            true};
}

AxisText default_other(const Subject& subject) {
    return {subject.table() + "." + subject.spec().axis, {0.01, {}, false}, {100, {}, false}, 9, true};
}

void check_ends(const StudySettings& settings, const MapAxis& axis) {
    for (const double end : {axis.values.front(), axis.values.back()}) {
        RunSettings run = settings.run;
        run.overrides.push_back(assignment(axis, end));
        const PlannedScene planned = plan_scene(run);
        if (!planned.plan.faults.empty())
            throw Fault(FaultKind::invalid,
                        fmt::format("--axis {}: {}", axis.path, all_sentences(planned.plan.faults)));
    }
}

void snap_steps(MapAxis& axis, double frame) {
    for (double& step : axis.values) step = frame / std::max(1.0, std::round(frame / step));
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    if (axis.values.size() < 2)
        throw Fault(FaultKind::invalid,
                    fmt::format("--axis {}: these steps come to one step of {}; expected two or "
                                "more that divide a frame of {}",
                                axis.path, seconds_text(axis.values[0]), seconds_text(frame)));
}

}  // namespace

std::string assignment(const MapAxis& axis, double value) { return fmt::format("{}={}", axis.path, value); }

std::vector<std::string> MapAxes::physics(std::size_t cell) const {
    std::vector<std::string> all;
    if (step_axis != 0) all.push_back(assignment(x, x_of(cell)));
    if (step_axis != 1) all.push_back(assignment(y, y_of(cell)));
    return all;
}

MapAxes choose_axes(const StudySettings& settings, const Subject& subject, const std::vector<AxisText>& asked,
                    const Deadline& deadline) {
    std::vector<AxisText> texts = asked;
    const std::string step = subject.table() + "." + subject.spec().step;
    if (texts.empty() || (texts.size() == 1 && texts[0].path != step))
        texts.insert(texts.begin(), default_step(settings, subject, deadline));
    if (texts.size() == 1) texts.push_back(default_other(subject));
    const PlannedScene planned = plan_scene(settings.run);
    MapAxes axes{resolve_axis(texts[0], planned.plan), resolve_axis(texts[1], planned.plan), -1};
    for (MapAxis* axis : {&axes.x, &axes.y}) {
        check_ends(settings, *axis);
        if (axis->table != subject.table() || axis->option != subject.spec().step) continue;
        snap_steps(*axis, subject.scene().step);
        axes.step_axis = axis == &axes.x ? 0 : 1;
    }
    return axes;
}

}  // namespace orbweaver::study
