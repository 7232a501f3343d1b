#pragma once

#include <optional>
#include <span>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// What a crawler is told.
struct Command {
    double pace = 1;  ///< periods of the gait in a period; below 0: backward
    double turn = 0;  ///< 1: as far to the left as it turns; -1: to the right
};

/// Keys that are held, told beforehand.
struct TimedCommand {
    double begin = 0, end = 0;  ///< s
    Command command;
};

/// What `script`, in order of its begins, says at `time` (s): of two at a time, the later one.
std::optional<Command> command_at(std::span<const TimedCommand> script, double time) noexcept;

/// A line to be followed.
struct Path {
    std::vector<Vec3> points;  ///< m
    bool loop = false;
    double ahead = 0;  ///< m
};
/// m, the point of the path `ahead` on from the one nearest to `position`; its end where it has one before.
Vec3 aim_along(const Path& path, const Vec3& position) noexcept;

/// The turn that leads a body at `position` (m) towards `aim`: by the sine of the angle in the plane across
/// `up`, all the way round where that is behind. `forward` and `up` are unit vectors.
double turn_towards(const Vec3& position, const Vec3& forward, const Vec3& up, const Vec3& aim) noexcept;

}  // namespace orbweaver::crawler
