#include "backbone.hpp"

#include <algorithm>
#include <optional>

#include "rotor.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kResponse = 0.2;  // s: a foot more or less on the ground does not jerk the back

/// Body frame, m, of the feet of legs [begin, end) that stand.
std::optional<Vec3> mean_foot(const BodyPose& body, const CreatureState& state, std::size_t begin,
                              std::size_t end) noexcept {
    Vec3 sum;
    std::size_t count = 0;
    for (std::size_t leg = begin; leg < end; ++leg) {
        if (state.progress[leg] >= 0 || !state.feet[leg].holds) continue;
        sum += from_world(body, state.feet[leg].place);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
}

}  // namespace

double wanted_bend(const Conduct& conduct, const CreatureState& state) noexcept {
    const Species& species = *conduct.species;
    const BodyPose body = pose_of(conduct, state);
    const std::size_t legs = species.limbs.size(), half = legs / 4 * 2;  // whole pairs; the middle one of three
    const auto front = mean_foot(body, state, 0, half), back = mean_foot(body, state, legs - half, legs);
    if (!front || !back || front->x <= back->x) return 0;
    const Vec3 behind = *back - *front;
    return std::clamp(angle_of(-behind.x, behind.y), species.body.bend_min, species.body.bend_max);
}

void bend_back(const Conduct& conduct, double dt, CreatureState& state) noexcept {
    const double most = conduct.turn_rate * kDegree * dt;
    const double wish = (wanted_bend(conduct, state) - state.bend) * std::min(1.0, dt / kResponse);
    state.bend += std::clamp(wish, -most, most);
}

}  // namespace orbweaver::spider
