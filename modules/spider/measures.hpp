#pragma once

#include <cstdint>
#include <span>

namespace orbweaver::spider {

/// What is counted over a creature's run.
struct CreatureMeasures {
    std::uint64_t frames = 0;
    std::uint64_t lost_frames = 0;         ///< in which the surface had no answer
    std::uint64_t turned_aside = 0;        ///< frames, from a border or from what no foot holds on
    std::uint64_t penetrating_frames = 0;  ///< in which the body reached below the surface
    std::uint64_t unstable_frames = 0;     ///< in which the stability margin was below 0
    std::uint64_t feet_down = 0;           ///< summed over frames
    std::uint64_t steps = 0;               ///< of feet
    std::uint64_t searches = 0;            ///< swings through the air of feet that found no foothold
    std::uint64_t forced_steps = 0;  ///< of feet that their legs no longer reached: they lifted out of turn
    double worst_reach = 0;          ///< of leg length, between a standing foot and its leg's end
    double worst_joint = 0;          ///< rad, past a limit
    double worst_penetration = 0;    ///< m, of the body below the surface; see penetration()
    double worst_turn = 0;           ///< degrees in a frame, of the body
    double worst_slip = 0;           ///< m in a frame, of a standing foot
    double least_margin = 1e300;     ///< m, of Support; at least minus the creature's height
    double margins = 0;              ///< m, summed over frames
    double distance = 0;             ///< m, walked
};

/// Of several creatures: sums, and the worst.
CreatureMeasures sum_of(std::span<const CreatureMeasures> all) noexcept;

}  // namespace orbweaver::spider
