#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/conditioning.hpp"
#include "study/statistics.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

/// One rung of one method's ladder.
struct AccuracyRow {
    Rung rung;
    std::optional<double> error_m;  ///< m, largest distance of a particle from the reference up to the horizon
    double wall_s = 0;              ///< s in the module's frames, median of the timed runs
    std::uint64_t steps = 0;
    std::string outcome;  ///< "done", "unresolved" (too near to the reference's own error), or an Ending
    std::optional<Deviation> deviation;  ///< of the statistics beyond the horizon, or of the whole run
    int runs = 1;                        ///< that were timed
};

/// What a study of accuracy found.
struct AccuracyResult {
    std::string scene;
    std::string table;
    double duration_s = 0;
    double frame_s = 0;
    std::size_t particles = 0;
    Conditioning conditioning;
    Deviation twin;  ///< of the displaced twin's statistics: what chance alone changes
    Rung reference;
    Rung second;                     ///< what the reference was confirmed by
    bool second_is_a_limit = false;  ///< its motion was extrapolated to a step of 0
    double uncertainty_m = 0;        ///< m, of the reference: its distance from the second
    double displacement_m = 0;       ///< m, the farthest that a particle of the reference gets from its start
    Statistics statistics;           ///< of the reference, from conditioning.statistics_row() on
    std::vector<AccuracyRow> rows;
    std::vector<std::size_t> front;      ///< rows that no other one beats in cost and error
    std::vector<std::string> sentences;  ///< what it comes to
};

inline constexpr double kUsualDuration = 1;  ///< s, the longest that is simulated unless asked

/// Runs every method over its ladder, against a reference that a second method confirms. Throws Fault(limit)
/// when the reference cannot be had in the time given, Fault(diverged) when its method does not get through.
AccuracyResult study_accuracy(const StudySettings& settings, const Subject& subject, const Deadline& deadline);

}  // namespace orbweaver::study
