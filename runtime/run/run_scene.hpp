#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "orbweaver/module.hpp"
#include "plan/plan.hpp"

namespace orbweaver {

/// What a command line asks of a run. Empty names: not asked.
struct RunSettings {
    std::string scene_path;
    std::vector<std::string> overrides;  ///< "path.to.key=value"
    std::vector<std::string> removals;   ///< "path.to.key", taken out of the scene before that
    std::vector<std::string> module_directories;
    Request request;
    bool endless = false;  ///< a window without a duration of its own runs until it is closed
    bool quiet = false;
    std::string trajectory_directory;
    std::string telemetry_file;
    std::string report_file;
    std::string save_state_file;
    std::string restore_state_file;
};

/// A scene read, overridden and planned. The plan points into the catalog.
struct PlannedScene {
    Catalog catalog;
    Plan plan;
};

/// Throws Fault when the scene cannot be read at all; every other fault is in plan.faults.
PlannedScene plan_scene(const RunSettings& settings);

/// Runs a scene to its end and leaves what was asked. Returns the process's exit code; says on standard error
/// why it is not 0.
int run_scene(const RunSettings& settings);

/// Plans, loads and attaches every module the scene asks for, view included, and runs nothing. Returns the exit
/// code.
int check_scene(RunSettings settings);

}  // namespace orbweaver
