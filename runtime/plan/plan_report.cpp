#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plan/plan.hpp"

namespace orbweaver {

namespace {

std::string libraries_text(const Manifest& manifest) {
    return manifest.libraries.empty() ? "" : fmt::format(" [{}]", fmt::join(manifest.libraries, ", "));
}

/// What the manifest has to say of the options that the scene gives.
std::vector<std::string> notes(const PlannedModule& module) {
    std::vector<std::string> all;
    for (const OptionSpec& option : module.manifest->options)
        if (!option.plan.empty() && module.options.given(option.key)) all.push_back(option.plan);
    return all;
}

}  // namespace

std::string plan_text(const Plan& plan) {
    std::string text = fmt::format("scene {}\n\nloaded, in this order:\n", plan.scene.name);
    if (plan.modules.empty()) text += "  nothing: the scene asks for no module\n";
    for (const PlannedModule& module : plan.modules) {
        text +=
            fmt::format("  {:<16} {}{}\n", module.instance, module.reason, libraries_text(*module.manifest));
        for (const std::string& note : notes(module)) text += fmt::format("  {:<16} {}\n", "", note);
    }
    text += "\nleft out:\n";
    for (const LeftOut& each : plan.left_out)
        text += fmt::format("  {:<16} {}{}\n", each.manifest->id, each.reason, libraries_text(*each.manifest));
    if (!plan.faults.empty()) {
        text += fmt::format("\n{} fault{}, so this plan cannot be run:\n", plan.faults.size(),
                            plan.faults.size() == 1 ? "" : "s");
        for (const Diagnostic& fault : plan.faults) text += fmt::format("  {}\n", to_string(fault));
    }
    return text;
}

std::string plan_json(const Plan& plan) {
    nlohmann::ordered_json json;
    json["scene"] = plan.scene.name;
    json["modules"] = nlohmann::ordered_json::array();
    for (const PlannedModule& module : plan.modules) {
        nlohmann::ordered_json phases = nlohmann::ordered_json::array();
        for (const Phase phase : module.manifest->phases) phases.push_back(to_string(phase));
        json["modules"].push_back({{"name", module.instance},
                                   {"module", module.manifest->id},
                                   {"version", module.manifest->version},
                                   {"reason", module.reason},
                                   {"library", module.manifest->library},
                                   {"brings", module.manifest->libraries},
                                   {"phases", phases},
                                   {"notes", notes(module)}});
    }
    json["left_out"] = nlohmann::ordered_json::array();
    for (const LeftOut& each : plan.left_out)
        json["left_out"].push_back({{"module", each.manifest->id},
                                    {"reason", each.reason},
                                    {"would_bring", each.manifest->libraries}});
    json["faults"] = nlohmann::ordered_json::array();
    for (const Diagnostic& fault : plan.faults)
        json["faults"].push_back({{"file", fault.where.file},
                                  {"line", fault.where.line},
                                  {"column", fault.where.column},
                                  {"what", fault.what},
                                  {"expected", fault.expected},
                                  {"remedy", fault.remedy}});
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace orbweaver
