#pragma once

#include <span>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// A creature's point on the surface: a point mass that moves along it. State of one creature.
struct Ground {
    Footing footing;       ///< its forward is where the last step led
    Vec3 velocity;         ///< m/s, across up
    Vec3 facing{1, 0, 0};  ///< unit, across up: where the head is
};

/// A place in the open next to somebody who stands, from where a look around begins: less than `off` m above
/// the face, and farther from its edges than that. Right above a crease up leads through the face that meets
/// it.
Vec3 next_to(const Surface& surface, const Footing& ground, double off) noexcept;

/// How a move ended.
enum class MoveEnd : std::uint8_t {
    moved,
    turned,  ///< at a border: it stands there or before it, and its velocity leads back
    lost,    ///< the surface had no answer: it stays where it was
};

/// From `ground` `length` m along `way` (unit, across its up), and on to other shells; tells of the corners
/// met.
SurfaceStride stride_along(const Surface& surface, Footing ground, const Vec3& way, double length,
                           std::span<StrideCorner> corners = {}) noexcept;

/// Along the surface by `way` (m/s, across up) * dt, straight on over edges and vertices, and on to other
/// shells that stand in the way; velocity and facing turn with the surface. Who has `headroom` m above it does
/// not go where there is less, as under a crate: that is like a border.
MoveEnd move(const Surface& surface, double dt, double headroom, Vec3 way, Ground& ground) noexcept;

/// Turns the head towards where the creature goes, by no more than `most_degrees`; one that stands looks on.
void face_ahead(double most_degrees, Ground& ground) noexcept;

/// What lies `reach` m ahead and behind along the surface: the paper's probe (ap Cenydd and Teahan 2005, 5.1),
/// by which a wall is felt before the creature arrives; and whether there is room above the surface there, at
/// least `headroom` m: where there is none it is as if it ended half way.
struct Feel {
    Vec3 up;  ///< unit: the mean of the ups ahead, here and behind; here's where they say nothing
    double corner_distance = 0;  ///< m, to the first corner ahead; beyond the reach: there is none
    double corner_degrees = 0;   ///< by which the surface turns there
    bool rises = false;          ///< an inside corner
    Vec3 corner_along;           ///< unit, along the edge, so that it leads on as the creature faces
    double border_distance = 0;  ///< m, to where the surface ends ahead; beyond the reach: it does not
    double room_left = 0, room_right = 0;  ///< m, to where it ends half left and half right, if it ends ahead
};
Feel feel_ahead(const Surface& surface, const Ground& ground, double reach, double headroom) noexcept;

}  // namespace orbweaver::spider
