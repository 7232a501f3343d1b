#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "support.hpp"

namespace orbweaver::spider {

/// When the legs of a cycle step: legs are numbered in pairs from front to back, right before left (R1 L1 R2 L2
/// ...). A leg starts `lag` of a cycle after the one behind it on its side, and the left one of a pair
/// `opposite` of a cycle after the right one.
struct Gait {
    std::string_view name;  ///< as scenes write it
    double lag = 0;
    double opposite = 0;
};

/// tetrapod: two sets of alternating legs, each moving from back to front in quick succession (Klaassen and
/// others 2001; Parker 1998); ripple: a wave along each side, four legs long; wave: one leg after the other.
/// Null where there is none of that name. The tetrapod of six legs is the tripod.
const Gait* find_gait(std::string_view name) noexcept;
std::span<const Gait> gaits() noexcept;

/// The start of leg `leg` of `legs` within a cycle, in [0, 1).
double start_of(const Gait& gait, std::size_t leg, std::size_t legs) noexcept;

/// How a creature steps at one speed: speed = stride * frequency, and a foot moves duty * stride against the
/// body while it stands.
struct Pace {
    double stride = 0;     ///< m, of the body in a cycle
    double frequency = 0;  ///< Hz, cycles a second
    double duty = 1;       ///< of a cycle that a foot stands
};

/// What a species can do.
struct PaceRange {
    double top_speed = 0;                            ///< m/s
    double shortest_stride = 0, longest_stride = 0;  ///< m, from rest to top speed
    double slow_duty = 0.75, fast_duty = 0.55;       ///< the same
};

/// Stride grows, and duty falls, in proportion to speed (m/s, taken between 0 and the top one).
Pace pace_at(const PaceRange& range, double speed) noexcept;

/// What a leg is doing.
enum class LegMotion : std::uint8_t { stands, swings };

/// Where one creature is in its cycle: all of it is state, in an owner's arrays of as many elements as it has
/// legs.
struct GaitState {
    double* phase = nullptr;     ///< of the cycle, in [0, 1); one number
    std::span<double> start;     ///< of each leg within a cycle, in [0, 1): it turns to what the gait asks
    std::span<double> progress;  ///< of each leg's swing, in [0, 1); below 0 while it stands
};

inline LegMotion motion_of(const GaitState& state, std::size_t leg) noexcept {
    return state.progress[leg] < 0 ? LegMotion::stands : LegMotion::swings;
}

/// At rest, as the gait begins.
void begin_gait(const Gait& gait, const GaitState& state) noexcept;

/// One frame of `dt` s. A standing leg lifts when its start comes; or at once where it is `strained` (an
/// element per leg, not 0 where it is), as long as its neighbors on its side and across stand. None lifts
/// while fewer than half of all would stand, nor, unless it is strained, where the creature would then be out
/// of balance: its center of mass, now or where it will be when the foot lands, outside the hull of the `feet`
/// that stand; one whose start comes then lifts as soon as it may. A swing takes (1 - duty) of a cycle, and no
/// longer than `landing_time` s, so that who stops puts its feet down. Starts turn to those of the gait, the
/// shorter way round, by at most `turn_rate` of a cycle a second, so that gaits blend without a jump. `lifted`
/// (an element per leg) is set to 1 where a leg lifted in this frame, `landed` where it came down; else to 0.
struct GaitTick {
    double dt = 0;
    double landing_time = 0.2;
    double turn_rate = 0.5;
    std::span<const std::uint8_t> strained;
    std::span<std::uint8_t> lifted, landed;
    std::span<const SupportPoint> feet;  ///< an element per leg; none: balance is not looked at
    SupportPoint velocity;               ///< m/s, of the center of mass
    std::span<const double> jitter;      ///< of a cycle, by which each leg's start is off; none: by nothing
};
void advance_gait(const Gait& gait, const Pace& pace, const GaitTick& tick, const GaitState& state) noexcept;

}  // namespace orbweaver::spider
