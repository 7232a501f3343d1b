#pragma once

#include <cstdint>

#include "ground.hpp"
#include "orbweaver/random.hpp"
#include "steering.hpp"

namespace orbweaver::spider {

/// Who comes to a wall decides whether to go along it or up (ap Cenydd and Teahan 2005, 5.3), and again after a
/// while.
struct WallSettings {
    double distance = 0;  ///< m, at which it goes along the wall
    double climb = 0;     ///< chance that it goes up
    double time = 5;      ///< s, that it keeps to what it decided: from half to one and a half times that
};

/// State of one creature.
struct WallState {
    int side = 0;         ///< where the wall is that it goes along, or turns to: 1 left, -1 right; 0: none
    bool climbs = false;  ///< it goes up the next wall it comes to
    double left = 0;      ///< s, until it decides anew
    std::uint64_t draws = 0;
};

/// The nearest inside corner of 30 degrees and more in one direction along the surface.
struct Wall {
    bool found = false;
    double distance = 0;  ///< m, straight to the corner's line
    Vec3 toward, along;   ///< unit, across up
};
Wall find_wall(const Surface& surface, const Footing& ground, const Vec3& way, double reach) noexcept;

/// The wish (see Agent) of a creature whose head is towards `facing` (unit, across up), dt seconds later; it
/// feels walls as far as `reach` m ahead. Nothing where there is no wall.
Vec3 follow_wall(const Surface& surface, const Ground& ground, const Agent& agent, double reach,
                 const WallSettings& settings, const RandomStream& random, double dt,
                 WallState& state) noexcept;

}  // namespace orbweaver::spider
