#pragma once

#include <span>

#include "crawl.hpp"
#include "crawler_options.hpp"
#include "journey.hpp"

namespace orbweaver::crawler {

/// What a body goes on from, besides its points; numbers of the state.
struct Pilot {
    double cycles = 0;  ///< of the gait, since the start
    double turn = 0;    ///< 1: as far to the left as it turns
    Journey journey;
};

/// Where a body looks whose points and center of mass are given (m): from the middle of its rear half to that
/// of its front half; up is what its rings say on the whole.
Pose heading_of(const Lattice& lattice, std::span<const Vec3> points, const Vec3& center) noexcept;

/// What it does of its own: straight on, or to where it is to go.
Command own_command(const Crawler& crawler, const Pose& heading) noexcept;

/// From `time` on for `step` s as it is told. Turns set in over a period, as all muscles do in the first one.
Drive go_on(const Crawler& crawler, const Command& command, double time, double step, Pilot& pilot) noexcept;
/// Muscles stay as they are at `time` (s).
Drive hold(const Crawler& crawler, const Pilot& pilot, double time) noexcept;

}  // namespace orbweaver::crawler
