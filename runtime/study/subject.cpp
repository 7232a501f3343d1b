#include "study/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "orbweaver/fault.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver::study {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& sentence) { throw Fault(FaultKind::invalid, sentence); }

}  // namespace

std::string seconds_text(double seconds) {
    if (seconds >= 1 || seconds == 0) return fmt::format("{:.3g} s", seconds);
    if (seconds >= 1e-3) return fmt::format("{:.3g} ms", seconds * 1e3);
    return seconds >= 1e-6 ? fmt::format("{:.3g} us", seconds * 1e6) : fmt::format("{:.3g} ns", seconds * 1e9);
}

std::string to_string(const Rung& rung) {
    return rung.tolerance > 0 ? fmt::format("{} at a tolerance of {:.3g} m", rung.method, rung.tolerance)
                              : fmt::format("{} at {}", rung.method, seconds_text(rung.step));
}

std::string all_sentences(const Diagnostics& faults) {
    std::vector<std::string> sentences;
    for (const Diagnostic& fault : faults)
        if (std::string said = orbweaver::to_string(fault); !contains(sentences, said))
            sentences.push_back(std::move(said));
    return fmt::format("{}", fmt::join(sentences, "\n"));
}

Subject::Subject(const StudySettings& settings) : full_duration_(settings.full_duration) {
    const PlannedScene planned = plan_scene(settings.run);
    if (!planned.plan.faults.empty()) refuse(all_sentences(planned.plan.faults));
    scene_ = planned.plan.scene;
    if (!(scene_.duration > 0))
        refuse(fmt::format("{}: it lasts {} s, in which there is nothing to study; expected a duration above 0",
                           settings.run.scene_path, scene_.duration));
    choose(settings, planned.plan);
    choose_methods(settings);
}

void Subject::choose(const StudySettings& settings, const Plan& plan) {
    std::set<std::string> tables;
    for (const PlannedModule& module : plan.modules) {
        if (!module.manifest->study) continue;
        const std::string& table = module.manifest->table;
        if (!settings.table.empty() && table != settings.table) continue;
        tables.insert(table);
        manifest_ = *module.manifest;
    }
    if (tables.size() == 1) return;
    if (tables.size() > 1)
        refuse(fmt::format("{}: {} can be studied, one at a time; say --table {}", settings.run.scene_path,
                           join_names(std::vector(tables.begin(), tables.end()), " and "), *tables.begin()));
    const std::string what = settings.table.empty() ? "no module of this scene"
                                                    : fmt::format("no [{}] of this scene", settings.table);
    refuse(
        fmt::format("{}: {} can be studied; expected a table whose module's manifest has [study], such as "
                    "[web]",
                    settings.run.scene_path, what));
}

void Subject::choose_methods(const StudySettings& settings) {
    std::vector<std::string> known = spec().steps;
    for (const std::string& method : spec().tolerances)
        if (!contains(known, method)) known.push_back(method);
    const auto check = [&](const char* option, const std::string& method) {
        if (contains(known, method)) return;
        const std::string nearest = nearest_name(method, known);
        refuse(fmt::format("{} {}: [{}] has no such method to study; expected {}{}", option, method, table(),
                           join_names(known), nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    };
    for (const std::string& method : settings.methods) check("--method", method);
    for (const std::string& method : settings.references) check("--references", method);
    if (settings.references.size() == 2 && settings.references[0] == settings.references[1])
        refuse(fmt::format("--references {0},{0}: a method cannot confirm itself; expected two different ones",
                           settings.references[0]));
    if (!settings.references.empty()) manifest_.study->references = settings.references;
    for (const std::string& method : known)
        if (settings.methods.empty() || contains(settings.methods, method)) methods_.push_back(method);
}

double Subject::duration(double usual) const noexcept {
    return full_duration_ ? scene_.duration : std::min(usual, scene_.duration);
}

bool Subject::by_tolerance(const std::string& method) const { return contains(spec().tolerances, method); }

bool Subject::by_step(const std::string& method) const { return contains(spec().steps, method); }

double Subject::least_tolerance() const {
    for (const OptionSpec& option : manifest_.options)
        if (option.key == spec().tolerance) return std::max(0.0, option.min);
    return 0;
}

Rung Subject::rung_within(const std::string& method, double longest) const {
    if (!by_step(method)) return {method, 0, std::max(1e-6, least_tolerance())};
    constexpr double kRounding = 1e-9;  // a third of a frame three times is a frame
    return rung(method, std::max(1.0, std::ceil(scene_.step / longest * (1 - kRounding))));
}

std::string Subject::assign(const std::string& option, const std::string& value) const {
    return fmt::format("{}.{}={}", table(), option, value);
}

std::string Subject::assign(const std::string& option, double value) const {
    return assign(option, fmt::format("{}", value));
}

std::vector<std::string> Subject::overrides(const Rung& rung) const {
    std::vector<std::string> all{assign(spec().method, rung.method), assign(spec().on_unstable, "as_asked")};
    if (rung.step > 0) all.push_back(assign(spec().step, rung.step));
    if (rung.tolerance > 0) all.push_back(assign(spec().tolerance, rung.tolerance));
    return all;
}

}  // namespace orbweaver::study
