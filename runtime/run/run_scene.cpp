#include "run/run_scene.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "output/atomic_file.hpp"
#include "output/loaded_libraries.hpp"
#include "output/progress.hpp"
#include "output/run_report.hpp"
#include "output/telemetry.hpp"
#include "output/trajectory.hpp"
#include "run/frame_loop.hpp"
#include "run/interrupt.hpp"
#include "run/session.hpp"
#include "run/snapshot.hpp"
#include "scene/overrides.hpp"
#include "scene/toml_reader.hpp"

namespace orbweaver {

namespace {

void print_faults(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults) fmt::print(stderr, "{}\n", to_string(fault));
    fmt::print(stderr, "{} fault{}; nothing was run\n", faults.size(), faults.size() == 1 ? "" : "s");
}

RunReport open_report(const RunSettings& settings, const Plan& plan) {
    RunReport report;
    report.scene = plan.scene.name;
    report.seed = plan.scene.seed;
    report.threads = settings.request.threads;
    report.step_s = plan.scene.step;
    for (const LeftOut& each : plan.left_out) report.left_out.emplace_back(each.manifest->id, each.reason);
    return report;
}

void add_session(RunReport& report, const Session& session) {
    report.state_hash = session.state_hash();
    report.loaded_libraries = loaded_libraries();
    for (const auto& instance : session.instances()) {
        RunReport::ModuleEntry entry{instance->instance_name(), instance->manifest().id,
                                     instance->wall_seconds(), 0, instance->report()};
        entry.memory_bytes = instance->block().bytes() + entry.report.memory_bytes;
        report.modules.push_back(std::move(entry));
    }
}

void write_report(const RunReport& report, const std::string& path) {
    AtomicFile file(path);
    file.write(report_json(report));
    file.commit();
}

/// The files that a run writes while it goes.
struct Recorders {
    std::unique_ptr<Trajectory> trajectory;
    std::unique_ptr<Telemetry> telemetry;

    Recorders(const RunSettings& settings, const Session& session) {
        if (!settings.trajectory_directory.empty())
            trajectory = std::make_unique<Trajectory>(session, settings.trajectory_directory);
        if (!settings.telemetry_file.empty())
            telemetry = std::make_unique<Telemetry>(session, settings.telemetry_file);
    }
    void record() const {
        if (trajectory) trajectory->record();
        if (telemetry) telemetry->record();
    }
    void commit() const {
        if (trajectory) trajectory->commit();
        if (telemetry) telemetry->commit();
    }
};

const char* outcome_of(FaultKind kind, bool started) {
    switch (kind) {
        case FaultKind::diverged:
            return started ? "diverged" : "refused";
        case FaultKind::limit:
            return "limit";
        default:
            return "failed";
    }
}

/// Steps the session, keeps whatever was good, and fills the report in. Throws the Fault that ended the run,
/// after everything is written.
void run_session(const RunSettings& settings, Session& session, RunReport& report) {
    const Interrupt interrupt;
    const Recorders recorders(settings, session);
    const std::uint64_t first = session.frame();
    const auto start = std::chrono::steady_clock::now();
    std::exception_ptr failure;
    report.outcome = "done";
    try {
        recorders.record();
        const bool finished = run_frames(session, {settings.request, settings.endless, settings.quiet},
                                         interrupt, [&] { recorders.record(); });
        if (!finished) report.outcome = "stopped";
    } catch (const Fault& fault) {
        failure = std::current_exception();
        report.outcome = outcome_of(fault.kind(), true);
        report.message = fault.what();
    }
    report.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report.frames = session.frame() - first;
    report.simulated_s = static_cast<double>(report.frames) * session.scene().step;
    add_session(report, session);
    try {
        recorders.commit();
        if (!settings.save_state_file.empty()) write_snapshot_file(session, settings.save_state_file);
        session.finish();
    } catch (const Fault& fault) {
        if (!failure) {
            failure = std::current_exception();
            report.outcome = outcome_of(fault.kind(), true);
            report.message = fault.what();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

void say_where(const RunSettings& settings) {
    const std::pair<const char*, const std::string&> outputs[] = {{"frames", settings.request.frames_directory},
                                                                  {"video", settings.request.video_file},
                                                                  {"trajectory", settings.trajectory_directory},
                                                                  {"telemetry", settings.telemetry_file},
                                                                  {"report", settings.report_file},
                                                                  {"state", settings.save_state_file}};
    for (const auto& [what, path] : outputs)
        if (!path.empty()) fmt::print("  {:<11}{}\n", what, path);
}

}  // namespace

PlannedScene plan_scene(const RunSettings& settings) {
    Node scene = read_toml_file(settings.scene_path);
    for (const std::string& assignment : settings.overrides) apply_override(scene, assignment);
    PlannedScene planned;
    planned.catalog = read_catalog(module_directories(settings.module_directories));
    planned.plan = make_plan(scene, settings.scene_path, planned.catalog, settings.request);
    return planned;
}

int run_scene(const RunSettings& settings) {
    const PlannedScene planned = plan_scene(settings);
    if (!planned.plan.faults.empty()) {
        print_faults(planned.plan.faults);
        return static_cast<int>(FaultKind::invalid);
    }
    RunReport report = open_report(settings, planned.plan);
    int code = 0;
    try {
        Session session(planned.plan, settings.request);
        if (!session.faults().empty()) {
            print_faults(session.faults());
            return static_cast<int>(FaultKind::invalid);
        }
        if (!settings.restore_state_file.empty()) read_snapshot_file(session, settings.restore_state_file);
        run_session(settings, session, report);
    } catch (const Fault& fault) {
        code = static_cast<int>(fault.kind());
        if (report.outcome.empty()) report.outcome = outcome_of(fault.kind(), false);
        if (report.message.empty()) report.message = fault.what();
        spdlog::error("{}", fault.what());
        if (report.outcome == "diverged")
            spdlog::error("the last good state is of time {:.6g} s{}", report.simulated_s,
                          settings.save_state_file.empty() ? "; --save-state FILE keeps it"
                                                           : ", in " + settings.save_state_file);
    }
    if (!settings.report_file.empty()) write_report(report, settings.report_file);
    if (!settings.quiet) {
        fmt::print("{}", report_text(report));
        say_where(settings);
    }
    return code;
}

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
