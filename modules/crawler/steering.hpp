#pragma once

#include <vector>

#include "orbweaver/timed.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// What a crawler is told.
struct Command {
    double pace = 1;  ///< periods of the gait in a period; below 0: backward
    double turn = 0;  ///< 1: as far to the left as it turns; -1: to the right
};

/// Keys that are held, told beforehand.
using TimedCommand = Timed<Command>;

/// A line to be followed.
struct Path {
    std::vector<Vec3> points;  ///< m
    bool loop = false;
    double ahead = 0;  ///< m
};
/// The turn that leads a body at `position` (m) towards `aim`: by the sine of the angle in the plane across
/// `up`, all the way round where that is behind. `forward` and `up` are unit vectors.
double turn_towards(const Vec3& position, const Vec3& forward, const Vec3& up, const Vec3& aim) noexcept;

}  // namespace orbweaver::crawler
