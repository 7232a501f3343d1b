#include "study/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "orbweaver/contracts/wind_field.hpp"
#include "orbweaver/contracts/writing_ways.hpp"
#include "orbweaver/fault.hpp"
#include "run/interrupt.hpp"
#include "run/session.hpp"
#include "study/accuracy.hpp"
#include "study/accuracy_files.hpp"
#include "study/queries.hpp"
#include "study/reaches.hpp"
#include "study/stability.hpp"
#include "study/stability_files.hpp"
#include "study/study_files.hpp"
#include "study/trial.hpp"
#include "study/ways_files.hpp"
#include "study/writings_files.hpp"

namespace orbweaver::study {

namespace {

namespace fs = std::filesystem;

constexpr double kUsualSway = 2;  ///< s for which a web that was written in sways
constexpr int kSwayingLooks = 4;  ///< while it does

bool contains(const std::vector<std::string>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

void print(const std::vector<std::string>& sentences, const std::string& folder) {
    for (const std::string& sentence : sentences) fmt::print("{}\n", sentence);
    fmt::print("written: {}/index.html\n", folder);
}

void print_duration(const Subject& subject, double usual) {
    const double duration = subject.duration(usual);
    const bool cut = duration < subject.scene().duration;
    fmt::print("{}: {} simulated in each run{}\n", subject.scene().name, seconds_text(duration),
               cut ? fmt::format(" of the scene's {}; --duration says otherwise",
                                 seconds_text(subject.scene().duration))
                   : "");
}

/// A scene that was attached, and is not run.
struct OpenedScene {
    OpenedScene(RunSettings run, const char* collected)
        : planned(plan_scene(collecting(run, collected))), session(checked(planned.plan), run.request) {
        if (!session.faults().empty()) throw Fault(FaultKind::invalid, all_sentences(session.faults()));
    }

    PlannedScene planned;
    Session session;

private:
    static const RunSettings& collecting(RunSettings& run, const char* contract) {
        run.request.collects = {contract};
        return run;
    }
    static const Plan& checked(const Plan& plan) {
        if (!plan.faults.empty()) throw Fault(FaultKind::invalid, all_sentences(plan.faults));
        return plan;
    }
};

/// `study` runs after its files were opened, and before they are written.
template <class Study>
void run_ways(const StudySettings& settings, const std::string& name, Study&& study) {
    StudyFiles files(settings.out, {name + ".csv", name + ".json", name + ".svg", "index.html"});
    const WaysResult result = study();
    files.commit({ways_csv(result), ways_json(result), ways_svg(result), ways_page(result)});
    print(result.sentences, settings.out);
}

std::string studied_scene() {
    std::error_code error;
    for (const std::string& assets : asset_directories(""))
        if (const fs::path path = fs::path(assets) / "studies" / "ik.toml"; fs::is_regular_file(path, error))
            return path.string();
    throw Fault(FaultKind::invalid,
                "assets/studies/ik.toml is missing; install Orbweaver's assets, or name a scene");
}

/// What names no file is what the module that offers ways of reaching calls its kinds by: "huntsman".
RunSettings scene_of_name(RunSettings run) {
    const std::string name = run.scene_path;
    std::error_code error;
    if (fs::exists(name, error) || name.find_first_of("/.\"\\") != std::string::npos) return run;
    for (const Manifest& manifest : read_catalog(module_directories(run.module_directories)).manifests)
        for (const OptionSpec& spec : manifest.options)
            if (spec.type == OptionType::named && contains(manifest.provides, ReachWays::kContract)) {
                run.scene_path = studied_scene();
                run.overrides.insert(run.overrides.begin(),
                                     {fmt::format("scene.name=\"{}\"", name),
                                      fmt::format("{}.{}=\"{}\"", manifest.table, spec.key, name)});
                return run;
            }
    return run;
}

/// At rest, and while wind blows.
std::vector<double> times_of(const Session& session, bool full_duration) {
    std::vector<double> times{0};
    if (session.find<WindField>() == nullptr) return times;
    const double duration = std::min(session.scene().duration, full_duration ? HUGE_VAL : kUsualSway);
    for (int i = 1; i <= kSwayingLooks; ++i) times.push_back(duration * i / kSwayingLooks);
    return times;
}

}  // namespace

void run_accuracy(const StudySettings& settings) {
    const Interrupt interrupt;
    const Subject subject(settings);
    set_up(settings, subject);
    StudyFiles files(settings.out, {"accuracy.csv", "accuracy_statistics.csv", "accuracy.json", "accuracy.svg",
                                    "index.html"});
    print_duration(subject, kUsualDuration);
    const AccuracyResult result = study_accuracy(settings, subject, deadline_in(settings.time, interrupt));
    files.commit({accuracy_csv(result), statistics_csv(result), accuracy_json(result), accuracy_svg(result),
                  accuracy_page(result)});
    print(accuracy_sentences(result), settings.out);
}

void run_stability(const StudySettings& settings, const std::vector<AxisText>& axes) {
    const Interrupt interrupt;
    const Subject subject(settings);
    set_up(settings, subject);
    StudyFiles files(settings.out, {"stability.csv", "stability.json", "stability.svg", "index.html"});
    print_duration(subject, kUsualCellDuration);
    const StabilityResult result =
        study_stability(settings, subject, axes, deadline_in(settings.time, interrupt));
    files.commit(
        {stability_csv(result), stability_json(result), stability_svg(result), stability_page(result)});
    print(result.sentences, settings.out);
}

void run_queries(const StudySettings& settings) {
    const Interrupt interrupt;
    const OpenedScene scene(settings.run, SurfaceWays::kContract);
    const Session& session = scene.session;
    const Surface* surface = session.find<Surface>();
    if (surface == nullptr)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: it has no surface to be asked; expected a table such as [surface]",
                                settings.run.scene_path));
    run_ways(settings, "queries", [&] {
        return study_queries(settings, session.scene().name, session.scene().seed, *surface,
                             session.collect<SurfaceWays>(), deadline_in(settings.time, interrupt));
    });
}

void run_reaches(const StudySettings& settings) {
    const Interrupt interrupt;
    const OpenedScene scene(scene_of_name(settings.run), ReachWays::kContract);
    const auto offers = scene.session.collect<ReachWays>();
    if (offers.size() != 1)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: it has {} tables of creatures with limbs; expected one, such as [spider]",
                                settings.run.scene_path, offers.size()));
    run_ways(settings, "ik", [&] {
        return study_reaches(settings, scene.session.scene().name, *offers.front(),
                             deadline_in(settings.time, interrupt));
    });
}

void run_writings(const StudySettings& settings) {
    const Interrupt interrupt;
    const OpenedScene scene(settings.run, WritingWays::kContract);
    const Session& session = scene.session;
    WritingWays* writing = session.find<WritingWays>();
    if (writing == nullptr)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: nothing is written in it; expected a table [inscription]",
                                settings.run.scene_path));
    StudyFiles files(settings.out, {"inscription.csv", "trade.csv", "readings.csv", "inscription.json",
                                    "inscription.svg", "trade.svg", "index.html"});
    const WritingsResult result =
        study_writings(settings, session.scene().name, *writing, times_of(session, settings.full_duration),
                       deadline_in(settings.time, interrupt));
    files.commit({ways_csv(result.ways), trade_csv(result), readings_csv(result), writings_json(result),
                  ways_svg(result.ways), trade_svg(result), writings_page(result)});
    print(result.ways.sentences, settings.out);
}

}  // namespace orbweaver::study
