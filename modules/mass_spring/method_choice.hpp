#pragma once

#include <cstdint>
#include <string>

#include "method.hpp"
#include "rehearsal.hpp"

namespace orbweaver::mass_spring {

/// What a run is to be like: so accurate, or so cheap.
struct ChoiceGoal {
    double tolerance = 0;                ///< m, over the run; 0: a budget instead
    double budget = 0;                   ///< s a frame, as SpringSystem::work_seconds() counts it
    std::int64_t max_substeps = 100000;  ///< steps of a frame, parts of divided ones counted
};

/// A method at a step, and what trials say of it.
struct MethodTrial {
    const MethodInfo* method = nullptr;
    double step = 0;       ///< s
    double error = 0;      ///< m, of the run
    double cost = 0;       ///< s a frame
    bool at_most = false;  ///< nothing more exact was there to tell its error from; no work was left for it
};

struct MethodChoice {
    MethodTrial chosen;
    bool meets_goal = false;
    std::string sentence;  ///< what was chosen, and against what
};

/// Picks method and step from trials in a Rehearsal, the cheapest first, each method from the longest step that
/// its stability and the frame allow, then at halves of it: the first whose error, four times over, is within
/// the tolerance, or the most accurate within the budget. What errs is told by the most exact run so far, which
/// is itself judged by half its step (Richardson); how errors of the frames that are tried become the run's, by
/// twins (ErrorGrowth). All of it takes at most 2 s of work, counted and not timed, so that the choice is the
/// same on every machine; but a first frame of each method is always tried. The system's surroundings are as
/// before when it returns. Throws Fault(diverged) when nothing holds in at most `max_substeps` steps a frame.
MethodChoice choose_method(SpringSystem& system, const RunAhead& run, const ChoiceGoal& goal);

}  // namespace orbweaver::mass_spring
