#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/map_axes.hpp"
#include "study/subject.hpp"
#include "study/time_budget.hpp"

namespace orbweaver::study {

/// What became of a run.
enum class CellClass : std::uint8_t {
    stable,    ///< it moves as its reference does
    degraded,  ///< it ended, at speeds more than twice those of its reference, or less than half
    diverged,  ///< it was stopped by values that mean nothing
    refused,   ///< it was not begun
    unknown,   ///< it was left out for lack of time, or has no reference
};
const char* to_string(CellClass kind) noexcept;

/// One method on the two axes.
struct StabilityMap {
    std::string method;
    std::vector<CellClass> cells;   ///< at row * columns + column
    std::vector<double> advised_s;  ///< s, the adviser's longest stable step for each value of the axis that is
                                    ///< not the step; empty when neither is
    std::optional<double> taken_step_s;  ///< s, that the scene as it stands takes with this method; nothing
                                         ///< when it does not get through a frame
    std::vector<std::string> reasons;    ///< of each cell, why it was refused; empty where it was not
};

struct StabilityResult {
    std::string scene;
    std::string table;
    double duration_s = 0;
    double asked_step_s = 0;  ///< s, the step that the scene asks for; its frame when it names none
    MapAxes axes;
    std::vector<StabilityMap> maps;
    std::vector<std::string> sentences;
};

/// s, the longest that is simulated in a cell unless asked.
inline constexpr double kUsualCellDuration = 0.5;
/// m, by which free particles are displaced at the start, so that no mode has to grow out of rounding.
inline constexpr double kNudge = 1e-9;
/// How many times faster or slower than its reference (rms speed between frames) a stable run may be.
inline constexpr double kSpeedFactor = 2;

/// Maps every method over two axes (see choose_axes()). Cells are run from long steps to short ones, so that it
/// is the most expensive ones that lack of time leaves out. Throws Fault(invalid) as choose_axes() does, and
/// Fault(limit) when there was no time for a single cell.
StabilityResult study_stability(const StudySettings& settings, const Subject& subject,
                                const std::vector<AxisText>& axes, const Deadline& deadline);

}  // namespace orbweaver::study
