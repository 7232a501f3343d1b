#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "cli/modules_command.hpp"
#include "cli/output_places.hpp"
#include "cli/picture_size.hpp"
#include "cli/program.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/study_command.hpp"
#include "orbweaver/build_stamp.hpp"
#include "orbweaver/fault.hpp"
#include "run/run_scene.hpp"

namespace {

using namespace orbweaver;

constexpr int kUsage = 2;

/// The command line as typed, before it becomes settings.
struct CommandLine {
    RunSettings settings;
    SceneArguments scene;
    std::string size;
    bool headless = false;
    bool json = false;
    std::string module_name;
};

// Not a number is no rate: it compares false.
bool is_rate(const std::string& text) {
    const auto rate = parse_number<double>(text);
    return rate && *rate >= 0.001 && *rate <= 1e6;
}

void add_request_options(CLI::App& command, CommandLine& line) {
    Request& request = line.settings.request;
    auto* headless = command.add_flag("--headless", line.headless, "no window (the default)");
    command.add_flag("--window", request.window, "show the scene in a window")->excludes(headless);
    command.add_option("--threads", request.threads, "threads to compute with")->check(CLI::Range(1, 256));
    command.add_option("--frames", request.frames_directory, "write PNG frames into this folder");
    command.add_option("--video", request.video_file,
                       "write a video: .mp4, .m4v, .mov or .mkv through ffmpeg when there is one, else .webp");
    command.add_option("--size", line.size, "size of pictures in pixels, WxH")
        ->check(checked([](const std::string& text) { return parse_picture_size(text).has_value(); },
                        "a size; expected WxH with 1 to 16384 pixels each, such as 1280x720"));
    command.add_option("--fps", request.frames_per_second, "pictures a second; one a frame when absent")
        ->check(checked(is_rate, "a rate; expected 0.001 to 1000000 pictures a second"));
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

void complete(CommandLine& line) {
    Request& request = line.settings.request;
    if (const auto size = parse_picture_size(line.size)) {
        request.width = size->width;
        request.height = size->height;
    }
    line.scene.complete(line.settings);
    line.settings.endless = request.window && line.scene.duration.empty();
    check_outputs(line.settings);
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
    line.scene.add_to(*run, line.settings);
    add_request_options(*run, line);
    add_run_options(*run, line);
    auto* plan = app.add_subcommand(
        "plan", "what a run would load, why, and what it would leave out; runs no module code");
    line.scene.add_to(*plan, line.settings);
    add_request_options(*plan, line);
    plan->add_flag("--json", line.json, "for a program to read");
    auto* check = app.add_subcommand("check", "find every fault of a scene, without running it");
    line.scene.add_to(*check, line.settings);
    StudyCommand study(app);
    auto* modules = app.add_subcommand("modules", "the modules found, and what their options mean");
    modules->add_option("NAME", line.module_name, "show one module in full");
    modules->add_option("--modules", line.settings.module_directories, "search this folder first; repeatable")
        ->allow_extra_args(false);
    try {
        app.parse(argc, argv);
        complete(line);
        study.complete();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : kUsage;
    }
    if (run->parsed()) return run_scene(line.settings);
    if (plan->parsed()) return print_plan(line);
    if (check->parsed()) return check_scene(line.settings);
    if (study.parsed()) return study.run();
    return print_modules(read_catalog(module_directories(line.settings.module_directories)), line.module_name);
}

}  // namespace

int main(int argc, char** argv) {
    return orbweaver::guarded_main([&] { return command_line(argc, argv); });
}
