#include "command.hpp"

namespace orbweaver::spider {

std::optional<Command> command_of_keys(int walk, int turn, const Command& fastest) noexcept {
    if (walk == 0 && turn == 0) return std::nullopt;
    return Command{walk * fastest.speed, turn * fastest.turn};
}

}  // namespace orbweaver::spider
