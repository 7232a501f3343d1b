#include "wall_following.hpp"

#include <algorithm>
#include <array>

namespace orbweaver::spider {
namespace {

constexpr std::uint64_t kOwnDraws = std::uint64_t{1} << 40;  // the stream is the creature's: others draw below

void decide(const WallSettings& settings, const RandomStream& random, WallState& state) noexcept {
    state.climbs = random.uniform(kOwnDraws + state.draws++) < settings.climb;
    state.left = settings.time * random.uniform(kOwnDraws + state.draws++, 0.5, 1.5);
}

int side_of(const Agent& agent, const Vec3& facing, const Vec3& toward) noexcept {
    return dot(cross(agent.up, facing), toward) >= 0 ? 1 : -1;
}

/// Along a wall at the side, nearer to it or farther from it by what its distance lacks.
Vec3 beside(const Agent& agent, const Vec3& facing, const Wall& wall, double wanted) noexcept {
    const Vec3 on = dot(wall.along, facing) < 0 ? -1 * wall.along : wall.along;
    const double off = std::clamp((wall.distance - wanted) / wanted, -1.0, 1.0);
    const Vec3 way = on + off * wall.toward;
    return (agent.top_speed / norm(way)) * way;
}

}  // namespace

Wall find_wall(const Surface& surface, const Footing& ground, const Vec3& way, double reach) noexcept {
    constexpr double kSlope = 0.866;  // the cosine of 30 degrees
    std::array<StrideCorner, 4> corners;
    const SurfaceStride stride = stride_along(surface, ground, way, reach, corners);
    if (stride.step.answer != Answer::found) return {};
    for (const StrideCorner& corner : std::span(corners).first(std::min<std::size_t>(stride.corners, 4))) {
        if (!corner.rises || dot(corner.up_before, corner.up_after) > kSlope) continue;
        const Vec3 along = across(cross(corner.up_before, corner.up_after), ground.up);
        const double length = norm(along);
        if (length < 1e-6) continue;
        Wall wall{true, 0, {}, along / length};
        const Vec3 toward = cross(wall.along, ground.up);
        const double off = dot(corner.position - ground.position, toward);
        wall.toward = off < 0 ? -1 * toward : toward;
        wall.distance = off < 0 ? -off : off;
        return wall;
    }
    return {};
}

Vec3 follow_wall(const Surface& surface, const Ground& ground, const Agent& agent, double reach,
                 const WallSettings& settings, const RandomStream& random, double dt,
                 WallState& state) noexcept {
    constexpr double kGivesUp = 4;    // times as fast as it would decide anew, where the wall has ended
    constexpr double kSlowest = 0.1;  // of its speed, before a wall that its head still looks at
    constexpr double kTurning = 0.5;  // s, that its head takes to turn
    const Vec3& facing = ground.facing;
    const Vec3 left = cross(agent.up, facing);
    state.left -= dt;
    const Wall ahead = find_wall(surface, ground.footing, facing, reach);
    const Wall side =
        state.side == 0 ? Wall{}
                        : find_wall(surface, ground.footing, state.side * left, 2 * settings.distance + reach);
    if (state.left <= 0) {
        if (!ahead.found && !side.found) {
            state.side = 0;
            state.climbs = false;
            return {};
        }
        decide(settings, random, state);
        if (!side.found) state.side = state.climbs ? 0 : side_of(agent, facing, ahead.toward);
    }
    if (state.climbs) {
        if (ahead.found) state.side = 0;
        const Wall& wall = ahead.found ? ahead : side;
        return wall.found ? agent.top_speed * wall.toward : Vec3{};
    }
    if (state.side == 0) return {};
    // A wall ahead stands across the one at the side: on along it, with it at the same side.
    if (ahead.found && ahead.distance < 2 * settings.distance + kTurning * agent.top_speed &&
        dot(ahead.toward, facing) > 0.5) {
        const Vec3 away = -state.side * left;
        const Vec3 way = beside(agent, dot(ahead.along, away) < 0 ? -1 * ahead.along : ahead.along, ahead,
                                settings.distance);
        return std::clamp(ahead.distance / settings.distance - 1, kSlowest, 1.0) * way;
    }
    if (side.found) return beside(agent, facing, side, settings.distance);
    if (ahead.found) return beside(agent, facing, ahead, settings.distance);
    state.left -= kGivesUp * dt;
    const Vec3 round = facing + (0.7 * state.side) * left;
    return (agent.top_speed / norm(round)) * round;
}

}  // namespace orbweaver::spider
