#pragma once

#include <string>
#include <vector>

#include "run/run_scene.hpp"
#include "study/study_settings.hpp"

namespace orbweaver::study {

/// A method of integration with what sets its accuracy: a step or a tolerance, the other being 0.
struct Rung {
    std::string method;
    double step = 0;       ///< s
    double tolerance = 0;  ///< m
};

/// "rk4 at 0.4 ms", "tsit5 at a tolerance of 1e-06 m"
std::string to_string(const Rung& rung);
/// "0.4 ms", "1.5 s"
std::string seconds_text(double seconds);

/// What a study varies and watches: every instance of one module whose manifest has [study].
class Subject {
public:
    /// Plans the scene. Throws Fault(invalid) with every fault of it, when nothing in it can be studied, when
    /// several tables can and none was named, or when a method was asked for that the module does not list.
    explicit Subject(const StudySettings& settings);

    const std::string& table() const noexcept { return manifest_.table; }
    const std::string& module() const noexcept { return manifest_.id; }
    const Manifest& manifest() const noexcept { return manifest_; }
    const StudySpec& spec() const noexcept { return *manifest_.study; }
    const SceneInfo& scene() const noexcept { return scene_; }
    /// s that each run simulates: the scene's duration, but at most `usual` unless all of it was asked for.
    double duration(double usual) const noexcept;
    /// Those asked for, else all, in the manifest's order.
    const std::vector<std::string>& methods() const noexcept { return methods_; }
    /// A method may be set by either; its accuracy is then studied by tolerances.
    bool by_tolerance(const std::string& method) const;
    bool by_step(const std::string& method) const;
    /// The smallest tolerance that the option allows, m; 0 when it names none.
    double least_tolerance() const;

    /// "web.step=0.001" for an option of the module.
    std::string assign(const std::string& option, const std::string& value) const;
    std::string assign(const std::string& option, double value) const;
    /// The overrides that make a run take this method with exactly this step or tolerance.
    std::vector<std::string> overrides(const Rung& rung) const;
    /// A step that divides the scene's frame `count` times.
    Rung rung(const std::string& method, double count) const { return {method, scene_.step / count, 0}; }
    /// The longest step of at most `longest` (s) that divides a frame; of methods that have none, a tolerance
    /// of 1 um, or the smallest there is above that.
    Rung rung_within(const std::string& method, double longest) const;

private:
    void choose(const StudySettings& settings, const Plan& plan);
    void choose_methods(const StudySettings& settings);

    Manifest manifest_;
    SceneInfo scene_;
    bool full_duration_ = false;
    std::vector<std::string> methods_;
};

/// Every fault in one sentence a line, said once though several instances have it, for Fault(invalid).
std::string all_sentences(const Diagnostics& faults);

}  // namespace orbweaver::study
