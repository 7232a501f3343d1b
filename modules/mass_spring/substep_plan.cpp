#include "substep_plan.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "quantity.hpp"

namespace orbweaver::mass_spring {
namespace {

std::string method_name(const SimulationSettings& settings) { return std::string(settings.method->name); }

std::string stable_text(const SimulationSettings& settings, const Advice& advice) {
    std::string text =
        "the largest stable one of " + method_name(settings) + ", " + seconds_text(advice.stable_step);
    if (advice.has_spring) text += ", set by " + describe_spring(settings, advice.spring);
    return text;
}

[[noreturn]] void refuse_any_step(const SimulationSettings& settings, const Advice& advice) {
    throw Fault(FaultKind::diverged,
                "no step of " + method_name(settings) + " is stable on an oscillation of " +
                    number_text(advice.angular_frequency) + " rad/s that next to nothing damps" +
                    (advice.has_spring ? ", strongest in " + describe_spring(settings, advice.spring) : "") +
                    "; choose symplectic_euler or rk4, or add drag and damping");
}

/// The number of equal steps of at most `step`, as a double: it may be more than any count can hold.
double count_steps(double frame_step, double step) {
    constexpr double kRounding = 1e-9;  // 20 ms in steps of 0.2 ms are 100, not 101
    return std::max(1.0, std::ceil(frame_step / step * (1 - kRounding)));
}

std::int64_t checked_count(const SimulationSettings& settings, double frame_step, double step,
                           const std::string& remedy) {
    const double count = count_steps(frame_step, step);
    if (count <= static_cast<double>(settings.max_substeps)) return static_cast<std::int64_t>(count);
    throw Fault(FaultKind::diverged, "a frame of " + seconds_text(frame_step) + " would take " +
                                         number_text(count) + " steps of " + seconds_text(step) +
                                         "; expected at most " + std::to_string(settings.max_substeps) + "; " +
                                         remedy);
}

std::int64_t count_as_asked(const SimulationSettings& settings, double frame_step, double asked) {
    return checked_count(settings, frame_step, asked, "ask for a longer step");
}

constexpr const char* kSoften = "lower stiffness, damping or drag, raise the masses, or raise max_substeps";

std::int64_t count_as_advised(const SimulationSettings& settings, const Advice& advice, double frame_step) {
    const double safe = kSafety * advice.stable_step;
    if (safe == 0) refuse_any_step(settings, advice);
    std::string remedy = kSoften;
    if (advice.has_spring) remedy += ", first of all at " + describe_spring(settings, advice.spring);
    return checked_count(settings, frame_step, safe, remedy);
}

}  // namespace

std::int64_t count_bounded(const SimulationSettings& settings, double step, double frame_step) {
    return checked_count(settings, frame_step, step, kSoften);
}

std::string describe_spring(const SimulationSettings& settings, std::size_t spring) {
    return settings.describe_spring ? settings.describe_spring(spring) : "spring " + std::to_string(spring);
}

SubstepPlan plan_substeps(const SimulationSettings& settings, const Advice& advice, double frame_step) {
    if (!(settings.step > 0)) return {count_as_advised(settings, advice, frame_step), {}};
    const double asked = std::min(settings.step, frame_step);
    if (asked <= advice.stable_step) return {count_as_asked(settings, frame_step, asked), {}};

    const std::string excess =
        "the asked step of " + seconds_text(asked) + " is longer than " + stable_text(settings, advice);
    if (settings.on_unstable == OnUnstable::as_asked) {
        return {count_as_asked(settings, frame_step, asked),
                excess + "; it is taken as asked, and will likely diverge"};
    }
    if (settings.on_unstable == OnUnstable::stop) {
        throw Fault(FaultKind::diverged, excess + "; ask for a shorter step, or for on_unstable = \"substep\"");
    }
    const std::int64_t count = count_as_advised(settings, advice, frame_step);
    const double taken = frame_step / static_cast<double>(count);
    return {count, excess + "; steps of " + seconds_text(taken) + " are taken instead"};
}

}  // namespace orbweaver::mass_spring
