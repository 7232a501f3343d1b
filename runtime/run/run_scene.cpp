#include "run/run_scene.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "output/loaded_libraries.hpp"
#include "output/run_report.hpp"
#include "run/current_fault.hpp"
#include "run/frame_loop.hpp"
#include "run/interrupt.hpp"
#include "run/recorders.hpp"
#include "run/session.hpp"
#include "run/snapshot.hpp"
#include "scene/overrides.hpp"
#include "scene/toml_reader.hpp"

namespace orbweaver {

namespace {

void print_faults(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults) std::fputs((to_string(fault) + "\n").c_str(), stderr);
    const char* plural = faults.size() == 1 ? "" : "s";
    std::fputs(fmt::format("{} fault{}; nothing was run\n", faults.size(), plural).c_str(), stderr);
}

void describe(RunReport& report, const RunSettings& settings, const Plan& plan) {
    report.scene = plan.scene.name;
    report.seed = plan.scene.seed;
    report.threads = settings.request.threads;
    report.step_s = plan.scene.step;
    for (const LeftOut& each : plan.left_out) report.left_out.emplace_back(each.manifest->id, each.reason);
}

void add_session(RunReport& report, const Session& session) {
    report.state_hash = session.state_hash();
    report.loaded_libraries = loaded_libraries();
    for (const auto& instance : session.instances()) {
        RunReport::ModuleEntry entry;
        entry.name = instance->instance_name();
        entry.module = instance->manifest().id;
        entry.setup_s = instance->setup_seconds();
        entry.wall_s = instance->wall_seconds();
        entry.report = instance->report();
        entry.memory_bytes = instance->block().bytes() + entry.report.memory_bytes;
        report.modules.push_back(std::move(entry));
    }
}

const char* outcome_of(FaultKind kind, bool started) {
    switch (kind) {
        case FaultKind::diverged:
            return started ? "diverged" : "refused";
        case FaultKind::limit:
            return "limit";
        case FaultKind::invalid:
            return "invalid";
        default:
            return "failed";
    }
}

/// One run, from its plan to its report. Whatever fails is said at once, and keeps nothing else from being
/// closed; the first failure is the run's outcome and exit code.
class SceneRun {
public:
    explicit SceneRun(const RunSettings& settings) : settings_(settings) {}

    int run() {
        attempt([&] { plan_and_run(); });
        if (report_file_) write_report();
        if (started_ && !settings_.quiet)
            attempt([&] {
                fmt::print("{}", report_text(report_));
                for (const auto& [what, path] : written_) fmt::print("  {:<11}{}\n", what, path);
            });
        return code_;
    }

private:
    template <class Step>
    bool attempt(Step&& step) {
        try {
            step();
            return true;
        } catch (...) {
            const Fault fault = current_fault();
            if (fault.what() != report_.message) spdlog::error("{}", fault.what());
            fail(fault.kind(), fault.what());
            return false;
        }
    }

    void fail(FaultKind kind, const std::string& message) {
        if (code_ != 0) return;
        code_ = static_cast<int>(kind);
        report_.outcome = outcome_of(kind, started_);
        report_.message = message;
    }

    void refuse(const Diagnostics& faults) {
        print_faults(faults);
        std::string message;
        for (const Diagnostic& fault : faults) message += (message.empty() ? "" : "\n") + to_string(fault);
        fail(FaultKind::invalid, message);
    }

    void plan_and_run() {
        report_.scene = settings_.scene_path;
        if (!settings_.report_file.empty()) report_file_.emplace(settings_.report_file);
        const PlannedScene planned = plan_scene(settings_);
        describe(report_, settings_, planned.plan);
        if (!planned.plan.faults.empty()) return refuse(planned.plan.faults);
        const Interrupt interrupt;
        Session session(planned.plan, settings_.request);
        if (!session.faults().empty()) return refuse(session.faults());
        if (!settings_.restore_state_file.empty()) read_snapshot_file(session, settings_.restore_state_file);
        const Recorders recorders(settings_, session);
        run_session(session, recorders, interrupt);
        close(session, recorders);
    }

    void run_session(Session& session, const Recorders& recorders, const Interrupt& interrupt) {
        const std::uint64_t first = session.frame();
        const auto start = std::chrono::steady_clock::now();
        started_ = true;
        report_.outcome = "done";
        attempt([&] {
            recorders.record();
            const bool finished = run_frames(session, {settings_.request, settings_.endless, settings_.quiet},
                                             interrupt, [&] { recorders.record(); });
            if (!finished) report_.outcome = "stopped";
        });
        report_.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        report_.frames = session.frame() - first;
        report_.simulated_s = static_cast<double>(report_.frames) * session.scene().step;
    }

    void close(Session& session, const Recorders& recorders) {
        const bool diverged = report_.outcome == "diverged";
        attempt([&] { session.finish(); });
        attempt([&] { add_session(report_, session); });
        list_pictures();
        if (recorders.trajectory && attempt([&] { recorders.trajectory->commit(); }) &&
            recorders.trajectory->whole())
            written_.emplace_back("trajectory", settings_.trajectory_directory);
        if (recorders.telemetry && attempt([&] { recorders.telemetry->commit(); }))
            written_.emplace_back("telemetry", settings_.telemetry_file);
        const bool saved = recorders.state && attempt([&] {
                               recorders.state->write(save_snapshot(session));
                               recorders.state->commit();
                           });
        if (saved) written_.emplace_back("state", settings_.save_state_file);
        if (diverged)
            spdlog::error("the last good state is of time {:.6g} s{}", session.time(),
                          saved ? ", in " + settings_.save_state_file : "; --save-state FILE keeps it");
    }

    // Whoever records pictures says in its measures what there is.
    void list_pictures() {
        for (const auto& module : report_.modules)
            for (const auto& [name, value] : module.report.measures)
                if (const auto* path = std::get_if<std::string>(&value);
                    path != nullptr && (name == "frames" || name == "video"))
                    written_.emplace_back(name, *path);
    }

    void write_report() {
        const bool done = attempt([&] {
            report_file_->write(report_json(report_));
            report_file_->commit();
        });
        if (done) written_.emplace_back("report", settings_.report_file);
    }

    const RunSettings& settings_;
    RunReport report_;
    std::optional<AtomicFile> report_file_;
    std::vector<std::pair<std::string, std::string>> written_;
    bool started_ = false;
    int code_ = 0;
};

}  // namespace

PlannedScene plan_scene(const RunSettings& settings) {
    Node scene = read_toml_file(settings.scene_path);
    for (const std::string& path : settings.removals) remove_value(scene, path);
    for (const std::string& assignment : settings.overrides) apply_override(scene, assignment);
    PlannedScene planned;
    planned.catalog = read_catalog(module_directories(settings.module_directories));
    planned.plan = make_plan(scene, settings.scene_path, planned.catalog, settings.request);
    return planned;
}

int run_scene(const RunSettings& settings) { return SceneRun(settings).run(); }

int check_scene(RunSettings settings) {
    settings.request.pictures = true;
    PlannedScene planned = plan_scene(settings);
    if (planned.plan.faults.empty()) {
        const Session session(planned.plan, settings.request);
        planned.plan.faults = session.faults();
    }
    if (!planned.plan.faults.empty()) {
        print_faults(planned.plan.faults);
        return static_cast<int>(FaultKind::invalid);
    }
    fmt::print("{}: no fault found\n", settings.scene_path);
    return 0;
}

}  // namespace orbweaver
