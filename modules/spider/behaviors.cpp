#include "behaviors.hpp"

#include <array>

namespace orbweaver::spider {
namespace {

constexpr double kHorizon = 5;          // s, over which others are foreseen
constexpr double kObstacleAhead = 1.5;  // s, over which obstacles are

}  // namespace

std::size_t memory_bytes(const Behaviors& b) noexcept {
    return b.seek.ways.memory_bytes() + b.flee.ways.memory_bytes() + b.arrive.ways.memory_bytes() +
           b.path.capacity() * sizeof(Vec3) + b.obstacles.capacity() * sizeof(Obstacle);
}

Vec3 combined(const Behaviors& b, const Agent& agent, const SurfacePoint& at, const Company& company,
              const Vec3& wandering, const Vec3& along_wall) noexcept {
    std::array<Wish, 10> wishes{{{wandering, b.wander}, {along_wall, b.follow_wall}}};
    std::size_t count = 2;
    const auto want = [&](double weight, auto wish) {
        if (weight > 0) wishes[count++] = {wish(), weight};
    };
    const auto is_within = [&](const Vec3& point, double reach) {
        return distance(agent.position, point) < reach;
    };
    want(b.seek.weight, [&] { return seek(agent, b.seek.ways.seen_from(at)); });
    want(b.flee.weight, [&] {
        const Vec3 seen = b.flee.ways.seen_from(at);
        return is_within(seen, b.flee_within) ? flee(agent, seen) : Vec3{};
    });
    want(b.arrive.weight, [&] { return arrive(agent, b.arrive.ways.seen_from(at), b.slowing); });
    if (company.quarry) want(b.pursue, [&] { return pursue(agent, *company.quarry, kHorizon); });
    if (is_hunted(b, agent, company)) want(b.evade, [&] { return evade(agent, *company.hunter, kHorizon); });
    want(b.follow_path, [&] { return follow_path(agent, b.path, b.loop, b.path_ahead); });
    want(b.avoid_obstacles, [&] { return avoid_obstacles(agent, b.obstacles, kObstacleAhead); });
    want(b.keep_apart, [&] { return keep_apart(agent, company.near, b.apart); });
    return blend(agent, std::span(wishes).first(count));
}

bool is_hunted(const Behaviors& b, const Agent& agent, const Company& company) noexcept {
    return b.evade > 0 && company.hunter && distance(agent.position, company.hunter->position) < b.evade_within;
}

std::optional<Agent> nearest_of(const Creatures& group, const Vec3& position, std::size_t self) noexcept {
    const std::span<const Vec3> positions = group.positions();
    std::optional<Agent> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double off = distance(positions[i], position);
        if (i == self || !(off < least)) continue;
        least = off;
        nearest = Agent{positions[i], group.velocities()[i], {}, 0};
    }
    return nearest;
}

}  // namespace orbweaver::spider
