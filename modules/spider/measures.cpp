#include "measures.hpp"

#include <algorithm>

namespace orbweaver::spider {

CreatureMeasures sum_of(std::span<const CreatureMeasures> all) noexcept {
    CreatureMeasures sum;
    for (const CreatureMeasures& each : all) {
        sum.frames += each.frames;
        sum.lost_frames += each.lost_frames;
        sum.turned_aside += each.turned_aside;
        sum.penetrating_frames += each.penetrating_frames;
        sum.unstable_frames += each.unstable_frames;
        sum.feet_down += each.feet_down;
        sum.steps += each.steps;
        sum.searches += each.searches;
        sum.forced_steps += each.forced_steps;
        sum.margins += each.margins;
        sum.distance += each.distance;
        sum.worst_reach = std::max(sum.worst_reach, each.worst_reach);
        sum.worst_joint = std::max(sum.worst_joint, each.worst_joint);
        sum.worst_penetration = std::max(sum.worst_penetration, each.worst_penetration);
        sum.worst_turn = std::max(sum.worst_turn, each.worst_turn);
        sum.worst_slip = std::max(sum.worst_slip, each.worst_slip);
        sum.least_margin = std::min(sum.least_margin, each.least_margin);
    }
    return sum;
}

}  // namespace orbweaver::spider
