#include "study/trial.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "orbweaver/fault.hpp"
#include "run/frame_loop.hpp"
#include "run/session.hpp"

namespace orbweaver::study {

namespace {

constexpr double kMostBytes = 5e8;

/// Steps past the stable one are what a study is about: nobody needs to be warned of each.
class QuietLog {
public:
    QuietLog() : before_(spdlog::get_level()) { spdlog::set_level(spdlog::level::err); }
    ~QuietLog() { spdlog::set_level(before_); }
    QuietLog(const QuietLog&) = delete;
    QuietLog& operator=(const QuietLog&) = delete;

private:
    spdlog::level::level_enum before_;
};

/// A session, with its eyes on the subject's instances.
class Watched {
public:
    Watched(const Subject& subject, const PlannedScene& planned, const Request& request)
        : session_(planned.plan, request) {
        if (!session_.faults().empty()) throw Fault(FaultKind::invalid, all_sentences(session_.faults()));
        for (const auto& instance : session_.instances())
            if (instance->manifest().id == subject.module()) add(*instance);
        motion_.frame_s = session_.scene().step;
        check_size();
    }

    void displace(std::span<const Vec3> offsets) {
        if (offsets.empty()) return;
        std::size_t next = 0;
        for (std::vector<Vec3>* positions : positions_)
            for (Vec3& place : *positions) place += offsets[next++];
        for (Instance* instance : instances_) instance->restored();
    }

    Ending run(const Deadline& deadline) {
        const std::uint64_t end = frame_count(session_.scene().duration, session_.scene().step);
        record_positions();
        while (session_.frame() < end) {
            if (deadline.passed()) return Ending::timeout;
            if (!session_.step([&] { return deadline.passed(); })) return Ending::timeout;
            record_positions();
            record_energy();
        }
        return Ending::done;
    }

    void close(Trial& trial) {
        session_.finish();
        for (Instance* instance : instances_) {
            const ModuleReport report = instance->report();
            trial.wall_s += instance->wall_seconds() - report.error.wall_s;
            trial.steps = std::max(trial.steps, report.steps);
            for (const auto& [name, value] : report.measures)
                if (const double* step = std::get_if<double>(&value);
                    step != nullptr && name == "stable_step_s")
                    trial.stable_step_s = std::min(trial.stable_step_s, *step);
        }
        trial.motion = std::move(motion_);
    }

private:
    void add(Instance& instance) {
        instances_.push_back(&instance);
        for (const TelemetryColumn& column : instance.telemetry_columns())
            if (column.name == "energy_j") energies_.push_back(&column);
        for (StateBlock::Entry& entry : instance.block().entries()) {
            auto* positions = std::get_if<std::vector<Vec3>>(&entry.data);
            if (positions == nullptr || entry.name != "position" || entry.info.unit != "m") continue;
            positions_.push_back(positions);
            motion_.particles += positions->size();
            return;
        }
        throw Fault(FaultKind::internal,
                    fmt::format("module '{}' cannot be studied: its state has no vectors \"position\" in m, "
                                "which the [study] of its manifest promises",
                                instance.instance_name()));
    }

    void check_size() const {
        const double frames = session_.scene().duration / session_.scene().step + 2;
        const double bytes = frames * static_cast<double>(motion_.particles) * sizeof(Vec3);
        if (bytes > kMostBytes)
            throw Fault(FaultKind::limit,
                        fmt::format("the positions of {} particles over {:.0f} frames take {:.3g} GB; expected "
                                    "at most {:g}; shorten --duration",
                                    motion_.particles, frames, bytes / 1e9, kMostBytes / 1e9));
    }

    void record_positions() {
        for (const std::vector<Vec3>* positions : positions_)
            motion_.positions.insert(motion_.positions.end(), positions->begin(), positions->end());
    }

    void record_energy() {
        if (energies_.size() != instances_.size()) return;
        double total = 0;
        for (const TelemetryColumn* column : energies_) total += column->value();
        motion_.energy_j.push_back(total);
    }

    Session session_;
    std::vector<Instance*> instances_;
    std::vector<std::vector<Vec3>*> positions_;
    std::vector<const TelemetryColumn*> energies_;
    Motion motion_;
};

bool is_result(FaultKind kind) { return kind == FaultKind::diverged || kind == FaultKind::limit; }

/// Takes a Fault as the trial's ending where it is one, and lets others pass.
void end_with(Trial& trial, const Fault& fault, Ending of_divergence) {
    trial.ending = fault.kind() == FaultKind::limit ? Ending::limit : of_divergence;
    trial.message = fault.what();
}

PlannedScene plan_sound_scene(const RunSettings& run) {
    PlannedScene planned = plan_scene(run);
    if (!planned.plan.faults.empty()) throw Fault(FaultKind::invalid, all_sentences(planned.plan.faults));
    return planned;
}

std::unique_ptr<Watched> open(const Subject& subject, const PlannedScene& planned, const Request& request,
                              Trial& trial) {
    try {
        return std::make_unique<Watched>(subject, planned, request);
    } catch (const Fault& fault) {
        if (fault.kind() != FaultKind::diverged && fault.kind() != FaultKind::invalid) throw;
        end_with(trial, fault, Ending::refused);
        return nullptr;
    }
}

void run_watched(Watched& watched, const TrialPlan& plan, const Deadline& deadline, Trial& trial) {
    try {
        watched.displace(plan.offsets);
        trial.ending = watched.run(deadline);
    } catch (const Fault& fault) {
        if (!is_result(fault.kind())) throw;
        end_with(trial, fault, Ending::diverged);
    }
    watched.close(trial);
}

}  // namespace

const char* to_string(Ending ending) noexcept {
    static constexpr const char* names[] = {"done", "diverged", "refused", "limit", "timeout"};
    return names[static_cast<std::size_t>(ending)];
}

void set_up(const StudySettings& settings, const Subject& subject) {
    const QuietLog quiet;
    const PlannedScene planned = plan_sound_scene(settings.run);
    try {
        const Watched as_it_is(subject, planned, settings.run.request);
    } catch (const Fault& fault) {
        if (fault.kind() != FaultKind::diverged) throw;  // the scene's own step may be refused: others are not
    }
}

Trial run_trial(const StudySettings& settings, const Subject& subject, const TrialPlan& plan,
                const Deadline& deadline) {
    const auto start = Deadline::Clock::now();
    const QuietLog quiet;
    RunSettings run = settings.run;
    // Methods that are set by their step refuse the scene's tolerance.
    if (!subject.spec().tolerance.empty())
        run.removals.push_back(subject.table() + "." + subject.spec().tolerance);
    // A method that is named refuses what helps to choose one, wherever that was said.
    for (const std::string& option : subject.spec().automatic) {
        const std::string path = subject.table() + "." + option;
        std::erase_if(run.overrides, [&](const std::string& text) { return text.starts_with(path + "="); });
        run.removals.push_back(path);
    }
    run.overrides.insert(run.overrides.end(), plan.overrides.begin(), plan.overrides.end());
    run.overrides.push_back(fmt::format("scene.duration={}", plan.duration));
    const PlannedScene planned = plan_sound_scene(run);
    Trial trial;
    if (const auto watched = open(subject, planned, run.request, trial))
        run_watched(*watched, plan, deadline, trial);
    trial.elapsed_s = std::chrono::duration<double>(Deadline::Clock::now() - start).count();
    return trial;
}

double stable_step(const StudySettings& settings, const Subject& subject, const std::string& method,
                   const std::vector<std::string>& changes, const Deadline& deadline) {
    auto overrides = subject.overrides(subject.rung_within(method, subject.scene().step));
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    return run_trial(settings, subject, {overrides, 0}, deadline).stable_step_s;
}

}  // namespace orbweaver::study
