#include "motion_options.hpp"

#include <string>

namespace orbweaver::web {

namespace {

using mass_spring::OnUnstable;

OnUnstable read_on_unstable(const std::string& name) {
    if (name == "stop") return OnUnstable::stop;
    return name == "as_asked" ? OnUnstable::as_asked : OnUnstable::substep;
}

std::string methods_with_tolerance() {
    std::string names;
    for (const mass_spring::MethodInfo& method : mass_spring::methods())
        if (method.embedded_order > 0) names += (names.empty() ? "" : ", ") + std::string(method.name);
    return names;
}

}  // namespace

mass_spring::SimulationSettings read_motion(const Options& options, Diagnostics& faults) {
    mass_spring::SimulationSettings settings;
    settings.method = mass_spring::find_method(options.text("method"));
    settings.step = options.has("step") ? options.number("step") : 0;
    settings.tolerance = options.has("tolerance") ? options.number("tolerance") : 0;
    settings.on_unstable = read_on_unstable(options.text("on_unstable"));
    settings.max_substeps = options.integer("max_substeps");
    if (settings.tolerance > 0 && settings.method->embedded_order == 0)
        faults.push_back({options.where("tolerance"),
                          "method " + options.text("method") + " does not tell the error of its steps",
                          "a tolerance with one of " + methods_with_tolerance(),
                          "choose another method, or say its step instead"});
    return settings;
}

}  // namespace orbweaver::web
