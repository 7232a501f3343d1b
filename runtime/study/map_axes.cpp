#include "study/map_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"

namespace orbweaver::study {

namespace {

constexpr const char* kFrame = "scene.step";

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& path, const std::string& sentence) {
    throw Fault(FaultKind::invalid, fmt::format("--axis {}: {}", path, sentence));
}

AxisText around(std::string path, double low, double high, int count) {
    return {std::move(path), AxisRange{{low, {}, false}, {high, {}, false}, count, true}};
}

AxisText default_step(const StudySettings& settings, const Subject& subject, const Plan& plan,
                      const Deadline& deadline) {
    constexpr double kOctaves = 0.75;  // between two steps
    const double frame = subject.scene().step;
    const double stable = stable_step(settings, subject, subject.spec().references[0], {}, deadline);
    const double middle = stable > 0 ? std::min(stable, frame) : frame;
    const double low = middle / 16;
    const double high = std::min(std::max(32 * middle, asked_step(subject, plan)), frame);
    const int count = 1 + static_cast<int>(std::lround(std::log2(high / low) / kOctaves));
    return around(subject.table() + "." + subject.spec().step, low, high, count);
}

AxisText default_other(const Subject& subject) {
    return around(subject.table() + "." + subject.spec().axis, 0.01, 100, 9);
}

/// Completes what was asked for to two axes.
std::vector<AxisText> complete(const StudySettings& settings, const Subject& subject, const Plan& plan,
                               std::vector<AxisText> asked, const Deadline& deadline) {
    const std::string step = subject.table() + "." + subject.spec().step;
    const auto is_asked = [&](const std::string& path) {
        return std::any_of(asked.begin(), asked.end(), [&](const AxisText& axis) { return axis.path == path; });
    };
    if (is_asked(step) && is_asked(kFrame))
        refuse(step,
               "steps are taken as asked only where they divide the frame, and the other axis varies the "
               "frame; vary one of the two");
    if (asked.size() < 2 && !is_asked(step) && !is_asked(kFrame))
        asked.insert(asked.begin(), default_step(settings, subject, plan, deadline));
    if (asked.size() < 2) asked.push_back(default_other(subject));
    return asked;
}

/// What a study decides itself cannot be varied.
void check_effect(const Subject& subject, const MapAxis& axis) {
    if (axis.table == "scene" && axis.option == "duration")
        refuse(axis.path,
               "it has no effect, since every cell is run for the same time; say --duration, and "
               "name another option");
    if (axis.table == "scene" && axis.option == "name")
        refuse(axis.path, "it has no effect on what is simulated; name another option");
    if (axis.table == subject.table() && axis.option == subject.spec().method)
        refuse(axis.path,
               "every method has a map of its own; choose them by --method, and name another option");
    if (axis.table == subject.table() && contains(subject.spec().automatic, axis.option))
        refuse(axis.path,
               "it has no effect, since every map is of one method, and this option only helps to choose one; "
               "name another option");
}

/// Refuses a value for what the scene says of its override, which was not typed as one.
[[noreturn]] void refuse_value(const MapAxis& axis, std::size_t i, std::string sentences) {
    const std::string typed = "--set " + axis.path + ": ";
    for (auto at = sentences.find(typed); at != std::string::npos; at = sentences.find(typed))
        sentences.erase(at, typed.size());
    refuse(axis.path + "=" + axis.text(i), sentences);
}

/// The value of an option in the scene as an axis changes it.
std::optional<OptionValue> changed_value(const StudySettings& settings, const MapAxis& axis, std::size_t i) {
    RunSettings run = settings.run;
    run.overrides.push_back(axis.assignment(i));
    std::string sentences;
    try {
        const PlannedScene planned = plan_scene(run);
        if (planned.plan.faults.empty()) return planned_value(axis, planned.plan);
        sentences = all_sentences(planned.plan.faults);
    } catch (const Fault& fault) {
        sentences = fault.what();
    }
    refuse_value(axis, i, std::move(sentences));
}

/// Of numbers the ends are tried, of labels each: the scene's own is the one that changes nothing.
void check_values(const StudySettings& settings, MapAxis& axis, const Plan& plan) {
    if (!axis.labelled()) {
        for (const std::size_t end : {std::size_t{0}, axis.values.size() - 1})
            changed_value(settings, axis, end);
        return;
    }
    const auto own = planned_value(axis, plan);
    for (std::size_t i = 0; i < axis.labels.size(); ++i)
        if (changed_value(settings, axis, i) == own && own) axis.own = axis.values[i];
}

void snap_steps(MapAxis& axis, double frame) {
    for (double& step : axis.values) step = frame / std::max(1.0, std::round(frame / step));
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    if (axis.values.size() < 2)
        refuse(axis.path, fmt::format("these steps come to one step of {}; expected two or more that divide a "
                                      "frame of {}",
                                      seconds_text(axis.values[0]), seconds_text(frame)));
}

}  // namespace

double MapAxes::step_of(std::size_t cell) const {
    return step_axis == 0 ? x.values[column(cell)] : step_axis == 1 ? y.values[row(cell)] : 0;
}

std::vector<std::string> MapAxes::physics(std::size_t cell) const {
    std::vector<std::string> all;
    if (x.physical) all.push_back(x.assignment(column(cell)));
    if (y.physical) all.push_back(y.assignment(row(cell)));
    return all;
}

double asked_step(const Subject& subject, const Plan& plan) {
    for (const PlannedModule& module : plan.modules)
        if (module.manifest->id == subject.module() && module.options.has(subject.spec().step))
            return module.options.number(subject.spec().step);
    return plan.scene.step;
}

MapAxes choose_axes(const StudySettings& settings, const Subject& subject, const std::vector<AxisText>& asked,
                    const Deadline& deadline) {
    const PlannedScene planned = plan_scene(settings.run);
    const auto texts = complete(settings, subject, planned.plan, asked, deadline);
    MapAxes axes{resolve_axis(texts[0], planned.plan), resolve_axis(texts[1], planned.plan), -1};
    const StudySpec& spec = subject.spec();
    for (MapAxis* axis : {&axes.x, &axes.y}) {
        check_effect(subject, *axis);
        check_values(settings, *axis, planned.plan);
        if (axis->table != subject.table()) continue;
        axis->physical = axis->option != spec.step && axis->option != spec.tolerance &&
                         axis->option != spec.on_unstable && !contains(spec.numerics, axis->option);
        if (axis->option != spec.step) continue;
        snap_steps(*axis, subject.scene().step);
        axes.step_axis = axis == &axes.x ? 0 : 1;
    }
    return axes;
}

}  // namespace orbweaver::study
