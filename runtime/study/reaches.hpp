#pragma once

#include "orbweaver/contracts/reach_ways.hpp"
#include "study/ways.hpp"

namespace orbweaver::study {

/// Has limbs reach for the same targets by every way that is offered: over tolerances, and over the steps of
/// one search. Throws Fault(invalid) for settings.methods that name no way.
WaysResult study_reaches(const StudySettings& settings, const std::string& scene, ReachWays& ways,
                         const Deadline& deadline);

}  // namespace orbweaver::study
