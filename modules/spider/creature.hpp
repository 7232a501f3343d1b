#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "behaviors.hpp"
#include "body_pose.hpp"
#include "footholds.hpp"
#include "gait.hpp"
#include "ground.hpp"
#include "leg_lanes.hpp"
#include "leg_solver.hpp"
#include "measures.hpp"
#include "motion.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/random.hpp"
#include "pauses.hpp"
#include "species.hpp"
#include "steering.hpp"
#include "stride_path.hpp"
#include "support.hpp"
#include "up_turn.hpp"
#include "wander.hpp"

namespace orbweaver::spider {

/// How a creature goes about: constant over a run, and shared by all of a kind.
struct Conduct {
    const Species* species = nullptr;
    const Gait* gait = nullptr;
    const StridePath* path = nullptr;  ///< of all swings; null: as they are for, see path_of()
    double jitter = 0;                 ///< of a cycle, that a leg is off its time at most, anew with each step
    const LegSolver* solver = nullptr;
    const LegLanes* lanes = nullptr;  ///< of the species' legs, for all at once; null: one after the other
    FootholdWay footholds = FootholdWay::surface;
    PaceRange pace;
    Behaviors behaviors;
    WanderSettings wander;
    PauseSettings pauses;
    bool rests = true;  ///< stops at random
    MotionMethod motion = MotionMethod::euler;
    double response = 0.15;  ///< s, in which it comes to the velocity that it wants
    double strength = 2;     ///< m/s^2, at most
    double turn_rate = 110;  ///< degrees a second, of head and up
    TurnCurve turn_curve = TurnCurve::linear;
    std::uint32_t turn_steps = 12;   ///< of a turn to a new polygon
    std::uint32_t orient_every = 1;  ///< frames, how often it looks for the up that it wants
    double slowest = 0.35;           ///< of its speed, at a right-angled corner
    Vec3 gravity;                    ///< m/s^2, that feet hold on against
};

/// A foot, of a leg of a creature.
struct Foot {
    Vec3 place;              ///< m; while it stands the same to the last bit
    Swing swing;             ///< under way, or the last one
    std::uint32_t path = 0;  ///< its form: of stride_paths()
    Vec3 home;               ///< m, body frame: where it is in the middle of its stance
    bool holds = false;      ///< it stands on the surface, or swings to a place on it; else it searches for one
    bool rim = false;        ///< that place is where the surface ends
    std::uint32_t searches = 0;  ///< swings since it last found one
};

/// Everything of a creature that changes over time.
struct CreatureState {
    Ground ground;
    UpTurn turn;
    Vec3 forward{1, 0, 0};  ///< unit, across the body's up
    Vec3 shift;             ///< m, by which the body keeps off what it would come too near to
    double depth = 0;       ///< m, by which the body is below the surface all the same
    double spin = 0;        ///< rad/s, of the body about its up, to the left
    Vec3 sway;              ///< m, by which it is going to lean towards the middle of its feet
    double strain = 0;      ///< of the standing leg that is strained the most: see strain_of()
    double bend = 0;        ///< rad, between thorax and abdomen, up is positive
    WanderState wander;
    WallState wall;
    PauseState pause;
    double phase = 0;
    std::array<double, kMaxLegs> start{}, progress{};
    std::array<double, kMaxLegs> jitter{};  ///< of a cycle, by which each leg is off its time
    std::uint64_t jitter_draws = 0;         ///< of random numbers for that so far
    std::array<Foot, kMaxLegs> feet;
    std::array<LegPose, kMaxLegs> poses{};
};

BodyPose pose_of(const Conduct& conduct, const CreatureState& state) noexcept;

/// What of a creature is not finite that others see: "position", "forward", "up", "a foot"; null: nothing.
const char* not_finite(const Conduct& conduct, const CreatureState& state) noexcept;

/// Whether a creature of a restored state stands where this surface is.
bool stands_on(const Surface& surface, const CreatureState& state) noexcept;

/// Puts a creature on the surface, all feet down under its rest pose.
void place_creature(const Surface& surface, const Conduct& conduct, const Footing& footing,
                    CreatureState& state) noexcept;

/// m, how far ahead and behind it feels.
double feel_reach(const Species& species) noexcept;
/// What it feels there, and whether there is room for it.
Feel feel_ground(const Surface& surface, const Species& species, const Ground& ground) noexcept;

/// One frame of dt s: feels, steers or obeys, moves, turns, steps and reaches.
void advance_creature(const Surface& surface, const Conduct& conduct, const Company& company, double dt,
                      CreatureState& state, CreatureMeasures& measures) noexcept;

/// Of the feet that stand, about the center of mass of the body and seen along its up.
Support support_of(const Conduct& conduct, const CreatureState& state) noexcept;

}  // namespace orbweaver::spider
