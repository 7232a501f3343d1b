#include "study/run_study.hpp"

#include <fmt/format.h>

#include "orbweaver/fault.hpp"
#include "run/interrupt.hpp"
#include "run/session.hpp"
#include "study/accuracy.hpp"
#include "study/accuracy_files.hpp"
#include "study/queries.hpp"
#include "study/queries_files.hpp"
#include "study/stability.hpp"
#include "study/stability_files.hpp"
#include "study/study_files.hpp"
#include "study/trial.hpp"

namespace orbweaver::study {

namespace {

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
    RunSettings run = settings.run;
    run.request.collects = {SurfaceWays::kContract};
    const PlannedScene planned = plan_scene(run);
    if (!planned.plan.faults.empty()) throw Fault(FaultKind::invalid, all_sentences(planned.plan.faults));
    const Session session(planned.plan, run.request);
    if (!session.faults().empty()) throw Fault(FaultKind::invalid, all_sentences(session.faults()));
    const Surface* surface = session.find<Surface>();
    if (surface == nullptr)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: it has no surface to be asked; expected a table such as [surface]",
                                run.scene_path));
    StudyFiles files(settings.out, {"queries.csv", "queries.json", "queries.svg", "index.html"});
    const QueryResult result =
        study_queries(settings, session.scene().name, session.scene().seed, *surface,
                      session.collect<SurfaceWays>(), deadline_in(settings.time, interrupt));
    files.commit({queries_csv(result), queries_json(result), queries_svg(result), queries_page(result)});
    print(result.sentences, settings.out);
}

}  // namespace orbweaver::study
