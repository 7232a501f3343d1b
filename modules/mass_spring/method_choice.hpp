#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// What a run is to be like: so accurate, or so cheap.
struct ChoiceGoal {
    double frame_step = 0;  ///< s
    double frames = 1;      ///< of the run
    double tolerance = 0;   ///< m, errors of single frames added up over the run; 0: a budget instead
    double budget = 0;      ///< s a frame, as SpringSystem::work_seconds() counts it
};

/// A method at a step, and what trials say of it.
struct MethodTrial {
    const MethodInfo* method = nullptr;
    double step = 0;   ///< s
    double error = 0;  ///< m, of the run
    double cost = 0;   ///< s a frame
};

struct MethodChoice {
    MethodTrial chosen;
    bool meets_goal = false;
    std::string sentence;  ///< what was chosen, and against what
};

/// Picks method and step from trials of a few frames each, under each of `loads` (external forces, N per
/// particle; none: as they are) suddenly put on: each method starts at the longest step that its stability and
/// the frame allow, and halves it until what the next halving changes (Richardson) is little enough (a quarter
/// of the tolerance), or it costs more than another way that is. Counts work instead of time, so that the
/// choice is the same on every machine. The system's surroundings are as before when it returns.
MethodChoice choose_method(SpringSystem& system, const Surroundings& surroundings, std::span<const Vec3> x,
                           std::span<const std::vector<Vec3>> loads, const ChoiceGoal& goal);

}  // namespace orbweaver::mass_spring
