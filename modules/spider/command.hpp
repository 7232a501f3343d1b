#pragma once

#include <optional>

#include "orbweaver/timed.hpp"

namespace orbweaver::spider {

/// What a creature is told to do by hand; it overrides all behaviors.
struct Command {
    double speed = 0;  ///< m/s ahead; below 0: back
    double turn = 0;   ///< degrees a second, to the left
};

/// Keys that are held, told beforehand.
using TimedCommand = Timed<Command>;

/// What keys say that are held (see InputEvents); nothing where none is. `fastest`: m/s, and degrees a second.
std::optional<Command> command_of_keys(int walk, int turn, const Command& fastest) noexcept;

}  // namespace orbweaver::spider
