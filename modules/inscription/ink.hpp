#pragma once

#include <span>

#include "orbweaver/contracts/threads.hpp"
#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// The silk that a viewer sees: in each pixel, the length (pixels) times the width of the threads within it.
Shades ink(std::span<const Vec3> points, std::span<const ThreadSegment> segments, const Page& page);

}  // namespace orbweaver::inscription
