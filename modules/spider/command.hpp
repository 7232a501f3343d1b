#pragma once

#include <optional>
#include <vector>

namespace orbweaver::spider {

/// What a creature is told to do by hand; it overrides all behaviors.
struct Command {
    double speed = 0;  ///< m/s ahead; below 0: back
    double turn = 0;   ///< degrees a second, to the left
};

/// Keys that are held, told beforehand.
struct TimedCommand {
    double begin = 0, end = 0;  ///< s
    Command command;
};

/// What `script`, in order of its begins, says of the frame that begins at `time` (s): of two at a time, the
/// later one. Ends and begins that rounding puts just beside a frame's begin are at it.
std::optional<Command> command_at(const std::vector<TimedCommand>& script, double time) noexcept;

/// What keys say that are held (see InputEvents); nothing where none is. `fastest`: m/s, and degrees a second.
std::optional<Command> command_of_keys(int walk, int turn, const Command& fastest) noexcept;

}  // namespace orbweaver::spider
