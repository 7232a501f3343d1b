#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/modules_command.hpp"
#include "orbweaver/build_stamp.hpp"
#include "orbweaver/fault.hpp"
#include "run/run_scene.hpp"
#include "scene/units.hpp"

namespace {

using namespace orbweaver;

constexpr int kUsage = 2;

/// The command line as typed, before it becomes settings.
struct CommandLine {
    RunSettings settings;
    std::string duration;
    std::string step;
    std::string seed;
    std::string size;
    bool headless = false;
    bool json = false;
    std::string module_name;
};

void add_scene_options(CLI::App& command, CommandLine& line) {
    command.add_option("SCENE", line.settings.scene_path, "the scene, a TOML file")->required();
    command
        .add_option("--set", line.settings.overrides,
                    "override a value of the scene: path.to.key=value; repeatable")
        ->allow_extra_args(false);
    command.add_option("--duration", line.duration, "how long, in seconds or with a unit (\"20 s\")");
    command.add_option("--step", line.step, "one frame, in seconds or with a unit (\"1/60 s\")");
    command.add_option("--seed", line.seed, "seed of every random stream");
    command
        .add_option("--modules", line.settings.module_directories,
                    "search this folder for modules first; repeatable")
        ->allow_extra_args(false);
}

void add_request_options(CLI::App& command, CommandLine& line) {
    Request& request = line.settings.request;
    auto* headless = command.add_flag("--headless", line.headless, "no window (the default)");
    command.add_flag("--window", request.window, "show the scene in a window")->excludes(headless);
    command.add_option("--threads", request.threads, "threads to compute with")->check(CLI::Range(1, 256));
    command.add_option("--frames", request.frames_directory, "write PNG frames into this folder");
    command.add_option("--video", request.video_file,
                       "write a video: .mp4 through ffmpeg when there is one, else .webp");
    command.add_option("--size", line.size, "size of pictures in pixels, WxH");
    command.add_option("--fps", request.frames_per_second, "pictures a second; one a frame when absent")
        ->check(CLI::Range(0.001, 1e6));
}

void add_run_options(CLI::App& command, CommandLine& line) {
    RunSettings& settings = line.settings;
    command.add_option("--trajectory", settings.trajectory_directory,
                       "write every recorded quantity into this folder, as NumPy .npy files");
    command.add_option("--telemetry", settings.telemetry_file, "write a CSV with a row a frame");
    command.add_option("--report", settings.report_file, "write the closing report as JSON");
    command.add_option("--save-state", settings.save_state_file,
                       "write the last good state, for --restore-state");
    command.add_option("--restore-state", settings.restore_state_file, "go on from a saved state");
    command.add_flag("--quiet", settings.quiet, "no progress, no closing lines");
}

// "1280x720" into the request; a usage error otherwise.
void read_size(const std::string& text, Request& request) {
    if (text.empty()) return;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &request.width, &request.height, &rest) != 2 ||
        request.width < 1 || request.height < 1 || request.width > 16384 || request.height > 16384)
        throw CLI::ValidationError(
            "--size",
            fmt::format("'{}' is not a size; expected WxH with 1 to 16384 pixels each, such as 1280x720",
                        text));
}

// A shorthand for --set scene.KEY=VALUE: numbers stay numbers, everything else is text.
void add_shorthand(CommandLine& line, const char* option, const char* key, const std::string& value,
                   bool quantity) {
    if (value.empty()) return;
    if (quantity && !parse_quantity(value))
        throw CLI::ValidationError(
            option, fmt::format("'{}' is not a time; expected seconds or a text such as \"20 s\"", value));
    const bool bare = value.find_first_not_of("0123456789.+-eE") == std::string::npos;
    line.settings.overrides.push_back(bare ? fmt::format("scene.{}={}", key, value)
                                           : fmt::format("scene.{}=\"{}\"", key, value));
}

void complete(CommandLine& line) {
    read_size(line.size, line.settings.request);
    add_shorthand(line, "--duration", "duration", line.duration, true);
    add_shorthand(line, "--step", "step", line.step, true);
    add_shorthand(line, "--seed", "seed", line.seed, false);
    line.settings.endless = line.settings.request.window && line.duration.empty();
}

int print_plan(const CommandLine& line) {
    const PlannedScene planned = plan_scene(line.settings);
    fmt::print("{}", line.json ? plan_json(planned.plan) : plan_text(planned.plan));
    return planned.plan.faults.empty() ? 0 : static_cast<int>(FaultKind::invalid);
}

int command_line(int argc, char** argv) {
    CLI::App app{"Orbweaver: spiders, their webs, and the legless things that crawl below them"};
    app.set_version_flag("--version", kVersion);
    app.require_subcommand(1);
    CommandLine line;
    auto* run = app.add_subcommand("run", "run a scene");
    add_scene_options(*run, line);
    add_request_options(*run, line);
    add_run_options(*run, line);
    auto* plan = app.add_subcommand(
        "plan", "what a run would load, why, and what it would leave out; runs no module code");
    add_scene_options(*plan, line);
    add_request_options(*plan, line);
    plan->add_flag("--json", line.json, "for a program to read");
    auto* check = app.add_subcommand("check", "find every fault of a scene, without running it");
    add_scene_options(*check, line);
    auto* modules = app.add_subcommand("modules", "the modules found, and what their options mean");
    modules->add_option("NAME", line.module_name, "show one module in full");
    modules->add_option("--modules", line.settings.module_directories, "search this folder first; repeatable")
        ->allow_extra_args(false);
    try {
        app.parse(argc, argv);
        complete(line);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kUsage;
    }
    if (run->parsed()) return run_scene(line.settings);
    if (plan->parsed()) return print_plan(line);
    if (check->parsed()) return check_scene(line.settings);
    return print_modules(read_catalog(module_directories(line.settings.module_directories)), line.module_name);
}

}  // namespace

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_color_st("orbweaver"));
    spdlog::set_pattern("%^%l%$: %v");
    try {
        return command_line(argc, argv);
    } catch (const Fault& fault) {
        spdlog::error("{}", fault.what());
        return static_cast<int>(fault.kind());
    } catch (const std::bad_alloc&) {
        spdlog::error("out of memory; ask for less, or give the process more");
        return static_cast<int>(FaultKind::limit);
    } catch (const std::exception& error) {
        spdlog::error("{}", error.what());
        return static_cast<int>(FaultKind::internal);
    }
}
