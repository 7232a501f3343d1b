#include "study/ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "scene/nearest_name.hpp"
#include "study/statistics.hpp"

namespace orbweaver::study {

namespace {

constexpr double kPass = 5e-3;  // s, that a timed pass takes at least

/// Numbers of the ways that were asked for; all when none was.
std::vector<std::size_t> chosen(const std::vector<Named>& ways, const std::vector<std::string>& wanted,
                                const std::string& doing) {
    std::vector<std::string> names;
    names.reserve(ways.size());
    for (const Named& way : ways) names.push_back(way.name);
    for (const std::string& name : wanted)
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            const std::string nearest = nearest_name(name, names);
            throw Fault(
                FaultKind::invalid,
                fmt::format("--method {}: there is no such way of {}; expected {}{}", name, doing,
                            join_names(names), nearest.empty() ? "" : "; did you mean " + nearest + "?"));
        }
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), names[i]) != wanted.end())
            numbers.push_back(i);
    return numbers;
}

class WaysStudy {
public:
    WaysStudy(const StudySettings& settings, Contest& contest, const Deadline& deadline, WaysResult& result)
        : settings_(settings), contest_(contest), deadline_(deadline), result_(result) {}

    void run() {
        const auto ways = chosen(contest_.ways(), settings_.methods, result_.words.doing);
        result_.tasks = contest_.tasks();
        for (const std::size_t way : ways) result_.ways.push_back(contest_.ways()[way]);
        Progress progress(result_.words.name, 0, result_.tasks.size() * ways.size(), 0, settings_.run.quiet,
                          "ways");
        std::size_t done = 0;
        for (std::size_t tasks = 0; tasks < result_.tasks.size(); ++tasks)
            for (const std::size_t way : ways) {
                if (contest_.suits(tasks, way)) try_settings(tasks, way);
                progress.update(++done);
            }
    }

private:
    void try_settings(std::size_t tasks, std::size_t way) {
        for (std::size_t setting = 0; setting < contest_.settings(tasks).size(); ++setting) {
            if (deadline_.passed()) {
                result_.sentences.push_back(fmt::format("{} by {}: left out {}", contest_.tasks()[tasks].name,
                                                        contest_.ways()[way].name, deadline_.why_passed()));
                return;
            }
            std::vector<double> passes(static_cast<std::size_t>(settings_.repeats));
            for (double& pass : passes) pass = timed(tasks, way, setting);
            WayRow row{contest_.tasks()[tasks].name,
                       contest_.ways()[way].name,
                       contest_.settings(tasks)[setting],
                       contest_.count(tasks),
                       0,
                       0,
                       0,
                       0,
                       median(std::move(passes))};
            contest_.judge(tasks, way, setting, row);
            result_.rows.push_back(std::move(row));
        }
    }

    /// s of processor time a task, done as often as a clock needs.
    double timed(std::size_t tasks, std::size_t way, std::size_t setting) const {
        const auto now = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
        const double start = now();
        double elapsed = 0;
        int times = 0;
        while (elapsed < kPass) {
            contest_.run(tasks, way, setting);
            elapsed = now() - start;
            ++times;
        }
        return elapsed / times / static_cast<double>(contest_.count(tasks));
    }

    const StudySettings& settings_;
    Contest& contest_;
    const Deadline& deadline_;
    WaysResult& result_;
};

}  // namespace

std::vector<WayRow> WaysResult::rows_of(const std::string& tasks) const {
    std::vector<WayRow> found;
    for (const WayRow& row : rows)
        if (row.tasks == tasks) found.push_back(row);
    return found;
}

void study_ways(const StudySettings& settings, Contest& contest, const Deadline& deadline, WaysResult& result) {
    WaysStudy(settings, contest, deadline, result).run();
}

void set_errors(std::vector<double> errors, WayRow& row) {
    if (errors.empty()) return;
    row.error = *std::max_element(errors.begin(), errors.end());
    row.median_error = median(std::move(errors));
}

}  // namespace orbweaver::study
