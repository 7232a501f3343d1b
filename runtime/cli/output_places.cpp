#include "cli/output_places.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <map>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

namespace fs = std::filesystem;

struct Output {
    const char* option;
    const std::string& path;  ///< empty: not asked for
};

std::array<Output, 4> outputs_of(const RunSettings& settings) {
    return {{{"--video", settings.request.video_file},
             {"--telemetry", settings.telemetry_file},
             {"--report", settings.report_file},
             {"--save-state", settings.save_state_file}}};
}

[[noreturn]] void refuse(const char* option, const std::string& path, const std::string& is) {
    throw CLI::ValidationError(option, fmt::format("'{}' is {}; name another", path, is));
}

fs::path place(const std::string& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

/// Whether a run with that trajectory writes `file`, a place.
bool is_of_trajectory(const fs::path& file, const std::string& trajectory) {
    return !trajectory.empty() && file.parent_path() == place(trajectory + "/any").parent_path() &&
           (file.extension() == ".npy" || file.filename() == "trajectory.json");
}

void keep_apart(const RunSettings& settings) {
    std::map<fs::path, const char*> taken;
    for (const auto& [option, path] : outputs_of(settings)) {
        if (path.empty()) continue;
        const fs::path file = place(path);
        const auto [before, is_new] = taken.emplace(file, option);
        if (!is_new) refuse(option, path, fmt::format("a file that {} writes", before->second));
        if (is_of_trajectory(file, settings.trajectory_directory))
            refuse(option, path, "a file that --trajectory writes");
    }
}

void keep_source(const RunSettings& settings, const std::string& source, const std::string& is) {
    for (const auto& [option, path] : outputs_of(settings))
        if (std::error_code ignored; !path.empty() && fs::equivalent(path, source, ignored))
            refuse(option, path, is);
    if (is_of_trajectory(place(source), settings.trajectory_directory))
        refuse("--trajectory", settings.trajectory_directory, fmt::format("where '{}' is, {}", source, is));
}

bool writes_files(const RunSettings& settings) {
    for (const Output& output : outputs_of(settings))
        if (!output.path.empty()) return true;
    return !settings.trajectory_directory.empty();
}

}  // namespace

void check_outputs(const RunSettings& settings) try {
    if (!writes_files(settings)) return;
    keep_source(settings, settings.scene_path, "the scene");
    keep_apart(settings);
    const PlannedScene planned = plan_scene(settings);
    for (const PlannedModule& module : planned.plan.modules)
        for (const OptionSpec& spec : module.manifest->options)
            if ((spec.type == OptionType::file || spec.type == OptionType::named) &&
                module.options.has(spec.key))
                keep_source(settings, module.options.text(spec.key),
                            fmt::format("what '{}.{}' of the scene reads", module.instance, spec.key));
} catch (const Fault&) {
    // the scene cannot be read
}

}  // namespace orbweaver
