#include "motion_options.hpp"

#include <string>

namespace orbweaver::web {

namespace {

std::string methods_with_tolerance() {
    std::string names;
    for (const mass_spring::MethodInfo& method : mass_spring::methods())
        if (method.embedded_order > 0) names += (names.empty() ? "" : ", ") + std::string(method.name);
    return names;
}

void check_goal(const Options& options, Diagnostics& faults) {
    if (options.has("step"))
        faults.push_back({options.where("step"), "method auto is told a step, which it chooses itself",
                          "no step, or the name of a method", "remove one of the two"});
    if (options.has("tolerance") != options.has("budget")) return;
    faults.push_back({options.where("method"),
                      std::string("method auto has ") + (options.has("budget") ? "two goals" : "no goal"),
                      "either a tolerance, as \"1e-4 m\" over the run, or a budget, as \"4 ms\" a frame", ""});
}

void check_tolerance(const Options& options, const mass_spring::SimulationSettings& settings,
                     Diagnostics& faults) {
    if (settings.tolerance == 0 || settings.method->embedded_order > 0) return;
    faults.push_back({options.where("tolerance"),
                      "method " + options.text("method") + " does not tell the error of its steps",
                      "a tolerance with one of " + methods_with_tolerance() + ", or with auto",
                      "choose another method, or say its step instead"});
}

}  // namespace

Motion read_motion(const Options& options, Diagnostics& faults) {
    Motion motion;
    mass_spring::SimulationSettings& settings = motion.settings;
    settings.method = mass_spring::find_method(options.text("method"));
    settings.on_unstable = mass_spring::on_unstable_named(options.text("on_unstable"));
    motion.linear_solver = mass_spring::linear_solver_named(options.text("linear_solver"));
    settings.max_substeps = options.integer("max_substeps");
    const double tolerance = options.has("tolerance") ? options.number("tolerance") : 0;
    if (settings.method == nullptr) {
        motion.tolerance = tolerance;
        motion.budget = options.has("budget") ? options.number("budget") : 0;
        check_goal(options, faults);
        return motion;
    }
    if (options.has("budget"))
        faults.push_back({options.where("budget"),
                          "method " + options.text("method") + " is given a budget, by which only auto chooses",
                          "a budget with method auto", "remove it, or choose auto"});
    settings.step = options.has("step") ? options.number("step") : 0;
    settings.tolerance = tolerance;
    check_tolerance(options, settings, faults);
    return motion;
}

void check_damping(const Options& options, const Motion& motion, const mass_spring::Network& network,
                   Diagnostics& faults) {
    const mass_spring::MethodInfo* method = motion.settings.method;
    if (method == nullptr || !method->undamped || !mass_spring::is_damped(network)) return;
    faults.push_back({options.where("method"),
                      "springs are damped, which method " + std::string(method->name) + " does not take",
                      "springs without damping, or another method, as tsit5",
                      "set their damping to 0 and let drag damp, or choose another method"});
}

}  // namespace orbweaver::web
