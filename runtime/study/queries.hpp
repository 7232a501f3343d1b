#pragma once

#include "orbweaver/contracts/surface_ways.hpp"
#include "study/ways.hpp"

namespace orbweaver::study {

/// Asks a surface the same questions by every way that is offered, and holds the answers against a reference of
/// its own. `seed` is that of the questions. Throws Fault(invalid) for settings.methods that name no way,
/// Fault(limit) when a way has no memory.
WaysResult study_queries(const StudySettings& settings, const std::string& scene, std::uint64_t seed,
                         const Surface& surface, const std::vector<SurfaceWays*>& offers,
                         const Deadline& deadline);

}  // namespace orbweaver::study
