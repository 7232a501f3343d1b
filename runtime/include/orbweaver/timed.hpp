#pragma once

#include <optional>
#include <span>

namespace orbweaver {

/// A command that holds for a while, told beforehand.
template <class Command>
struct Timed {
    double begin = 0, end = 0;  ///< s
    Command command;
};

/// What `script`, in order of its begins, says of the frame that begins at `time` (s): of two at a time, the
/// later one. Ends and begins that rounding puts just beside a frame's begin are at it.
template <class Command>
std::optional<Command> command_in(std::span<const Timed<Command>> script, double time) noexcept {
    constexpr double kRounding = 1e-9;  // s
    std::optional<Command> command;
    for (const Timed<Command>& each : script)
        if (each.begin <= time + kRounding && time + kRounding < each.end) command = each.command;
    return command;
}

}  // namespace orbweaver
