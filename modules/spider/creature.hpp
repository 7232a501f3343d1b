#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "behaviors.hpp"
#include "footholds.hpp"
#include "gait.hpp"
#include "ground.hpp"
#include "leg_solver.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/random.hpp"
#include "pauses.hpp"
#include "species.hpp"
#include "steering.hpp"
#include "stride_path.hpp"
#include "up_turn.hpp"
#include "wander.hpp"

namespace orbweaver::spider {

/// How a creature goes about: constant over a run, and shared by all of a kind.
struct Conduct {
    const Species* species = nullptr;
    const Gait* gait = nullptr;
    const StridePath* path = nullptr;
    const LegSolver* solver = nullptr;
    FootholdWay footholds = FootholdWay::surface;
    PaceRange pace;
    Behaviors behaviors;
    WanderSettings wander;
    PauseSettings pauses;
    bool rests = true;       ///< stops at random
    double response = 0.15;  ///< s, in which it comes to the velocity that it wants
    double strength = 2;     ///< m/s^2, at most
    double turn_rate = 110;  ///< degrees a second, of head and up
    TurnCurve turn_curve = TurnCurve::cosine;
    std::uint32_t turn_steps = 12;  ///< of a turn to a new polygon
    double slowest = 0.35;          ///< of its speed, at a right-angled corner
    Vec3 gravity;                   ///< m/s^2, that feet hold on against
};

/// A foot, of a leg of a creature.
struct Foot {
    Vec3 place;          ///< m; while it stands the same to the last bit
    Swing swing;         ///< under way, or the last one
    bool holds = false;  ///< it stands on the surface, or swings to a place on it
};

/// Everything of a creature that changes over time.
struct CreatureState {
    Ground ground;
    UpTurn turn;
    Vec3 shift;  ///< m, by which the body keeps off what it would come too near to
    WanderState wander;
    WallState wall;
    PauseState pause;
    double phase = 0;
    std::array<double, kMaxLegs> start{}, progress{};
    std::array<Foot, kMaxLegs> feet;
    std::array<LegPose, kMaxLegs> poses{};
};

/// Where a body is: its frame's origin is the thorax's middle.
struct BodyPose {
    Vec3 position;            ///< m
    Vec3 forward, up, right;  ///< unit
};
BodyPose pose_of(const Conduct& conduct, const CreatureState& state) noexcept;
Vec3 to_world(const BodyPose& pose, const Vec3& point) noexcept;  ///< from the body's frame, m
Vec3 from_world(const BodyPose& pose, const Vec3& point) noexcept;

/// What is counted over a run.
struct CreatureMeasures {
    std::uint64_t frames = 0;
    std::uint64_t lost_frames = 0;   ///< in which the surface had no answer
    std::uint64_t turned_aside = 0;  ///< frames, from a border or from what no foot holds on
    std::uint64_t feet_down = 0;     ///< summed over frames
    std::uint64_t steps = 0;         ///< of feet
    std::uint64_t empty_steps = 0;   ///< that found no foothold
    std::uint64_t forced_steps = 0;  ///< of feet that their legs no longer reached: they lifted out of turn
    double worst_reach = 0;          ///< of leg length, between a standing foot and its leg's end
    double worst_joint = 0;          ///< rad, past a limit
    double worst_penetration = 0;    ///< m, of the body's middle axis below the surface
    double worst_turn = 0;           ///< degrees in a frame, of the body's up
    double worst_slip = 0;           ///< m in a frame, of a standing foot
    double least_margin = 1e300;     ///< m, see stability_margin()
    double distance = 0;             ///< m, walked
};

/// Puts a creature on the surface, all feet down under its rest pose.
void place_creature(const Surface& surface, const Conduct& conduct, const Footing& footing,
                    CreatureState& state) noexcept;

/// One frame of dt s: feels, steers or obeys, moves, turns, steps and reaches.
void advance_creature(const Surface& surface, const Conduct& conduct, const Company& company, double dt,
                      CreatureState& state, CreatureMeasures& measures) noexcept;

/// m, along the surface: how far the body's middle is within the hull of the feet that stand, seen along its
/// up; below 0 where it is outside, or fewer than three stand.
double stability_margin(const Conduct& conduct, const CreatureState& state) noexcept;

/// Of several creatures: sums, and the worst.
CreatureMeasures sum_of(std::span<const CreatureMeasures> all) noexcept;

}  // namespace orbweaver::spider
