#include "command.hpp"

namespace orbweaver::spider {

std::optional<Command> command_at(const std::vector<TimedCommand>& script, double time) noexcept {
    constexpr double kRounding = 1e-9;  // s
    std::optional<Command> command;
    for (const TimedCommand& each : script)
        if (each.begin <= time + kRounding && time + kRounding < each.end) command = each.command;
    return command;
}

std::optional<Command> command_of_keys(int walk, int turn, const Command& fastest) noexcept {
    if (walk == 0 && turn == 0) return std::nullopt;
    return Command{walk * fastest.speed, turn * fastest.turn};
}

}  // namespace orbweaver::spider
