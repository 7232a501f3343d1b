#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "study/study_settings.hpp"
#include "study/time_budget.hpp"

namespace orbweaver::study {

struct Named {
    std::string name;
    std::string meaning;  ///< in a few words
};

/// How one way did with one kind of tasks.
struct WayRow {
    std::string tasks;    ///< "vertices"
    std::string way;      ///< "wide_tree"
    std::string setting;  ///< "tolerance 1e-06"; empty: the way has none
    std::size_t asked = 0;
    std::size_t missed = 0;    ///< tasks not done
    std::size_t invented = 0;  ///< tasks said to be done that are not
    double error = 0;          ///< largest, in the study's unit
    double median_error = 0;
    double cost_s = 0;  ///< s of processor time a task, median of the timed passes
};

/// What a study calls things.
struct WaysWords {
    std::string name;     ///< "queries": of the study, and of its files
    std::string tasks;    ///< "questions"
    std::string task;     ///< "question"
    std::string doing;    ///< "asking"
    std::string unit;     ///< of errors: "m"; empty: they have none
    std::string error;    ///< "largest error / m"
    std::string title;    ///< "queries of its surface"
    std::string reading;  ///< how to read the plots
    bool has_settings = false;
};

/// Of what was asked: ("triangles", 108); a count stays exact.
using Fact = std::pair<std::string, std::variant<std::uint64_t, double>>;

/// What a study of ways found.
struct WaysResult {
    WaysWords words;
    std::string scene;
    std::vector<Fact> facts;
    std::vector<Named> tasks;  ///< kinds of tasks
    std::vector<Named> ways;
    std::vector<WayRow> rows;
    std::vector<std::string> sentences;  ///< what it comes to

    /// The rows of one kind of tasks.
    std::vector<WayRow> rows_of(const std::string& tasks) const;
};

/// Tasks of several kinds, each of which can be done in several ways.
class Contest {
public:
    virtual ~Contest() = default;

    virtual const std::vector<Named>& tasks() const = 0;
    virtual const std::vector<Named>& ways() const = 0;
    /// How much trouble a way may take over tasks of a kind; {""} where there is nothing to be set.
    virtual const std::vector<std::string>& settings(std::size_t tasks) const = 0;
    virtual std::size_t count(std::size_t tasks) const = 0;
    virtual bool suits(std::size_t tasks, std::size_t way) const = 0;
    /// Does all tasks of a kind: this is timed.
    virtual void run(std::size_t tasks, std::size_t way, std::size_t setting) = 0;
    /// What came of the last run: missed, invented and errors. Throws Fault(limit) where a way had no memory.
    virtual void judge(std::size_t tasks, std::size_t way, std::size_t setting, WayRow& row) = 0;
};

/// Has every kind of tasks done by every way that was asked for. Adds rows, and sentences for what there was no
/// time for, to `result`. Throws Fault(invalid) for settings.methods that name no way.
void study_ways(const StudySettings& settings, Contest& contest, const Deadline& deadline, WaysResult& result);

/// The largest and the median of some errors, of which there may be none.
void set_errors(std::vector<double> errors, WayRow& row);

}  // namespace orbweaver::study
