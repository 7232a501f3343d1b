#pragma once

#include <cstdint>

#include "orbweaver/random.hpp"

namespace orbweaver::spider {

/// A creature that stops at random, twitches its palps, and goes on after a random time: what arachnophobes
/// found most alive (ap Cenydd and Teahan 2005, 5.3).
struct PauseSettings {
    double walk_least = 2, walk_most = 8;      ///< s
    double pause_least = 0.5, pause_most = 3;  ///< s
    double twitch_rate = 7;                    ///< Hz, of the palps while it stands
};

/// State of one creature.
struct PauseState {
    bool stands = false;
    double left = 0;          ///< s, until it changes
    double stood = 0;         ///< s
    std::uint64_t draws = 0;  ///< of random numbers so far
};

/// dt seconds later.
void advance_pauses(const PauseSettings& settings, const RandomStream& random, double dt,
                    PauseState& state) noexcept;

/// How far a palp is raised, from -1 to 1: 0 while it walks, else swinging in bursts, the right one out of step
/// with the left.
double twitch(const PauseSettings& settings, const PauseState& state, bool right) noexcept;

}  // namespace orbweaver::spider
