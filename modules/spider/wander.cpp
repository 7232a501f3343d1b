#include "wander.hpp"

#include <algorithm>

namespace orbweaver::spider {
namespace {

/// Evenly from the unit ball, or the unit circle's disc.
Vec3 any_way(const RandomStream& random, bool on_ball, std::uint64_t& draws) noexcept {
    for (;;) {
        Vec3 way{random.uniform(draws, -1, 1), random.uniform(draws + 1, -1, 1),
                 on_ball ? random.uniform(draws + 2, -1, 1) : 0};
        draws += 3;
        const double square = dot(way, way);
        if (square > 1e-6 && square <= 1) return way;
    }
}

Vec3 displaced(const WanderSettings& settings, const RandomStream& random, WanderState& state) noexcept {
    const Vec3 way = any_way(random, settings.on_ball, state.draws);
    const Vec3 moved = state.point + std::min(settings.displacement, 1e3) * way;
    const double length = norm(moved);
    return length > 1e-9 ? moved / length : state.point;
}

}  // namespace

Vec3 wander(const Agent& agent, const Vec3& forward, const WanderSettings& settings, const RandomStream& random,
            double dt, WanderState& state) noexcept {
    state.wait -= dt;
    while (state.wait < 0 && settings.rate > 0) {
        state.point = displaced(settings, random, state);
        state.wait += 1 / settings.rate;
    }
    const Vec3 left = cross(agent.up, forward);
    const Vec3 way = (settings.ahead + state.point.x) * forward + state.point.y * left;
    const double length = norm(way);
    return length > 1e-9 ? (agent.top_speed / length) * way : Vec3{};
}

}  // namespace orbweaver::spider
