#pragma once

#include <cstddef>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// A creature as a point that steers itself along a surface (C. Reynolds, Steering Behaviors for Autonomous
/// Characters, 1999). Every behavior below yields a velocity that the creature would like to have, in the plane
/// across `up`; nothing where it has no wish.
struct Agent {
    Vec3 position;         ///< m
    Vec3 velocity;         ///< m/s, across up
    Vec3 up;               ///< unit, away from the surface
    double top_speed = 0;  ///< m/s
};

/// Straight to `target` (m), at top speed.
Vec3 seek(const Agent& agent, const Vec3& target) noexcept;
/// Straight away from it.
Vec3 flee(const Agent& agent, const Vec3& target) noexcept;
/// To it, slower within `slowing` m of it, so as to stand there.
Vec3 arrive(const Agent& agent, const Vec3& target, double slowing) noexcept;
/// To where the agent at top speed meets a quarry that goes straight on, foreseen over at most `horizon` s.
Vec3 pursue(const Agent& agent, const Agent& quarry, double horizon) noexcept;
/// Away from where it would meet a hunter.
Vec3 evade(const Agent& agent, const Agent& hunter, double horizon) noexcept;
/// Along a line through `points` (m), from the first to the last, and on to the first where it is a `loop`: to
/// the point of it `ahead` m further on than the one nearest to the agent; to the last point of an open one as
/// if to arrive. Nothing where there are no points.
Vec3 follow_path(const Agent& agent, std::span<const Vec3> points, bool loop, double ahead) noexcept;

/// A ball to keep clear of.
struct Obstacle {
    Vec3 center;        ///< m
    double radius = 0;  ///< m, the agent's own included
};
/// Past whatever obstacle the agent would run into within `horizon` s, on the side on which its center is not;
/// nothing where it is clear of all. The nearest one counts; balls that do not touch the agent's plane do not.
Vec3 avoid_obstacles(const Agent& agent, std::span<const Obstacle> obstacles, double horizon) noexcept;
/// Away from others nearer than `reach` m, the nearer the more.
Vec3 keep_apart(const Agent& agent, std::span<const Vec3> others, double reach) noexcept;

/// A behavior's wish, and how much it counts.
struct Wish {
    Vec3 velocity;      ///< m/s; nothing: does not count
    double weight = 0;  ///< >= 0
};
/// m/s: the weighted mean of wishes; where there is none, the agent goes on as it does.
Vec3 blend(const Agent& agent, std::span<const Wish> wishes) noexcept;
/// The one control signal, m/s^2: what brings the agent to a velocity that is wanted (m/s) within `response` s,
/// no more than `strength` m/s^2.
Vec3 control(const Agent& agent, const Vec3& wanted, double response, double strength) noexcept;

/// Forward Euler over dt seconds, as the paper moves its creature's point mass: the velocity after it, across
/// up and no faster than the top speed.
Vec3 accelerate(const Agent& agent, const Vec3& control, double dt) noexcept;

/// The part of its speed that a creature keeps which sees its up turn by `degrees` at `distance` m ahead, from
/// 1 down to `slowest`: the sharper and nearer, the slower; all of it beyond `reach` m.
double caution(double degrees, double distance, double reach, double slowest) noexcept;

}  // namespace orbweaver::spider
