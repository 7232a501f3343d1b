#pragma once

#include <cstdint>

#include "orbweaver/random.hpp"
#include "orbweaver/vec3.hpp"
#include "steering.hpp"

namespace orbweaver::spider {

/// How a creature wanders: a point on a ball (or a circle in the surface's plane) in front of it is displaced
/// at random now and then, and it heads for that point. Small displacements at a high rate make a lizard's
/// arcs, large ones at a low rate the turns of a house spider (ap Cenydd and Teahan 2005, 3.1).
struct WanderSettings {
    double ahead = 1;         ///< of the ball's center, in its radii
    double displacement = 0;  ///< of the point at a time, in radii; beyond 2 it is anywhere
    double rate = 0;          ///< displacements a second
    bool on_ball = true;      ///< false: on a circle
};

/// State of one creature.
struct WanderState {
    Vec3 point{1, 0, 0};      ///< unit: forward, left, up
    double wait = 0;          ///< s to the next displacement
    std::uint64_t draws = 0;  ///< of random numbers so far
};

/// The wish (see Agent) of a creature that faces `forward` (unit, across up), dt seconds later.
Vec3 wander(const Agent& agent, const Vec3& forward, const WanderSettings& settings, const RandomStream& random,
            double dt, WanderState& state) noexcept;

}  // namespace orbweaver::spider
