#pragma once

#include <cstdint>
#include <string>

#include "adviser.hpp"
#include "simulation_settings.hpp"

namespace orbweaver::mass_spring {

/// How a frame is cut into steps.
struct SubstepPlan {
    std::int64_t count = 1;
    std::string warning;  ///< why it is not, or should not be, as asked; empty: nothing to say
};

/// The fewest equal steps of a frame that are no longer than the asked one, or than 0.9 of the stable one
/// when that is not asked or not to be had. Throws Fault(diverged) as Simulation says.
SubstepPlan plan_substeps(const SimulationSettings& settings, const Advice& advice, double frame_step);

/// Of a stable step, how much is taken: the tangent moves between two looks at it.
inline constexpr double kSafety = 0.9;

/// The fewest equal steps of a frame that are no longer than `step`, stable in every arrangement. Throws
/// Fault(diverged) when there are too many.
std::int64_t count_bounded(const SimulationSettings& settings, double step, double frame_step);

/// "spring 12 (radius, 3 to 7)" as the owner describes it.
std::string describe_spring(const SimulationSettings& settings, std::size_t spring);

}  // namespace orbweaver::mass_spring
