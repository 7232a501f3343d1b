#include "output/run_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace orbweaver {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: a figure that is not finite is written as null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json measures_json(const ModuleReport& report) {
    Json json = Json::object();
    for (const auto& [name, value] : report.measures) {
        if (const double* figure = std::get_if<double>(&value))
            json[name] = number(*figure);
        else if (const auto* count = std::get_if<std::int64_t>(&value))
            json[name] = *count;
        else
            json[name] = std::get<std::string>(value);
    }
    return json;
}

std::string error_text(const ModuleReport& report) {
    if (!report.has_error) return "none: nothing is approximated over time";
    if (std::isnan(report.error.value)) return fmt::format("not known ({})", report.error.how);
    return fmt::format("{:.2g} {} ({})", report.error.value, report.error.unit, report.error.how);
}

Json module_json(const RunReport::ModuleEntry& module) {
    Json json = {{"name", module.name},
                 {"module", module.module},
                 {"method", module.report.method},
                 {"steps", module.report.steps},
                 {"setup_s", module.setup_s},
                 {"wall_s", module.wall_s},
                 {"memory_bytes", module.memory_bytes}};
    if (module.report.has_error)
        json["error_estimate"] = {{"value", number(module.report.error.value)},
                                  {"unit", module.report.error.unit},
                                  {"how", module.report.error.how},
                                  {"wall_s", module.report.error.wall_s}};
    else
        json["error_estimate"] = nullptr;
    json["measures"] = measures_json(module.report);
    return json;
}

}  // namespace

std::string report_json(const RunReport& report) {
    Json json = {{"scene", report.scene},
                 {"seed", report.seed},
                 {"threads", report.threads},
                 {"step_s", report.step_s},
                 {"frames", report.frames},
                 {"simulated_s", report.simulated_s},
                 {"wall_s", report.wall_s},
                 {"real_time_factor", report.real_time_factor()},
                 {"outcome", report.outcome},
                 {"message", report.message},
                 {"state_hash", fmt::format("{:016x}", report.state_hash)},
                 {"loaded_libraries", report.loaded_libraries}};
    json["left_out"] = Json::array();
    for (const auto& [module, reason] : report.left_out)
        json["left_out"].push_back({{"module", module}, {"reason", reason}});
    json["modules"] = Json::array();
    for (const auto& module : report.modules) json["modules"].push_back(module_json(module));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_text(const RunReport& report) {
    std::string text =
        fmt::format("{}: {}, {} frames, {:.6g} s simulated in {:.3g} s, {:.3g} x real time, state {:016x}\n",
                    report.scene, report.outcome, report.frames, report.simulated_s, report.wall_s,
                    report.real_time_factor(), report.state_hash);
    text += fmt::format("  {:<16} {:<18} {:>10} {:>10} {:>10} {:>10}  {}\n", "module", "method", "steps",
                        "set-up s", "cost s", "memory kB", "error");
    for (const auto& module : report.modules) {
        const std::string error = error_text(module.report);
        text +=
            fmt::format("  {:<16} {:<18} {:>10} {:>10.3f} {:>10.3f} {:>10.1f}  {}\n", module.name,
                        module.report.method.empty() ? "-" : module.report.method, module.report.steps,
                        module.setup_s, module.wall_s, static_cast<double>(module.memory_bytes) / 1000, error);
    }
    return text;
}

}  // namespace orbweaver
