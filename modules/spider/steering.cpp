#include "steering.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/polyline.hpp"

namespace orbweaver::spider {
namespace {

/// Of that length, or nothing where v has no direction.
Vec3 scaled_to(const Vec3& v, double length) noexcept {
    const double own = norm(v);
    return own > 0 ? (length / own) * v : Vec3{};
}

Vec3 at_most(const Vec3& v, double length) noexcept { return norm(v) > length ? scaled_to(v, length) : v; }

/// Where `other` is when the agent meets it: |d + v t| = s t, the first t > 0; the horizon where there is none.
Vec3 foreseen(const Agent& agent, const Agent& other, double horizon) noexcept {
    const Vec3 d = other.position - agent.position;
    const Vec3& v = other.velocity;
    const double c = dot(d, d), b = dot(d, v), a = dot(v, v) - agent.top_speed * agent.top_speed;
    const double below = b * b - a * c;
    const double divisor = below >= 0 ? std::sqrt(below) - b : 0;
    const double time = divisor > 0 ? std::min(horizon, c / divisor) : horizon;
    return other.position + time * v;
}

}  // namespace

Vec3 seek(const Agent& agent, const Vec3& target) noexcept {
    return scaled_to(across(target - agent.position, agent.up), agent.top_speed);
}

Vec3 flee(const Agent& agent, const Vec3& target) noexcept { return -1 * seek(agent, target); }

Vec3 arrive(const Agent& agent, const Vec3& target, double slowing) noexcept {
    const Vec3 way = across(target - agent.position, agent.up);
    const double share = slowing > 0 ? std::min(1.0, norm(way) / slowing) : 1;
    return scaled_to(way, share * agent.top_speed);
}

Vec3 pursue(const Agent& agent, const Agent& quarry, double horizon) noexcept {
    return seek(agent, foreseen(agent, quarry, horizon));
}

Vec3 evade(const Agent& agent, const Agent& hunter, double horizon) noexcept {
    return flee(agent, foreseen(agent, hunter, horizon));
}

Vec3 follow_path(const Agent& agent, std::span<const Vec3> points, bool loop, double ahead) noexcept {
    if (points.empty()) return {};
    const PointAhead aim = ahead_on(points, loop, agent.position, ahead);
    return aim.is_end ? arrive(agent, aim.point, ahead) : seek(agent, aim.point);
}

Vec3 avoid_obstacles(const Agent& agent, std::span<const Obstacle> obstacles, double horizon) noexcept {
    const double speed = norm(agent.velocity);
    if (speed == 0) return {};
    const Vec3 ahead = agent.velocity / speed;
    const Obstacle* nearest = nullptr;
    double nearest_way = speed * horizon;
    for (const Obstacle& each : obstacles) {
        if (std::abs(dot(each.center - agent.position, agent.up)) >= each.radius) continue;
        const Vec3 to = across(each.center - agent.position, agent.up);
        const double way = dot(to, ahead);
        const double beside = norm(to - way * ahead);
        if (way <= 0 || way - each.radius >= nearest_way || beside >= each.radius) continue;
        nearest = &each;
        nearest_way = way - each.radius;
    }
    if (nearest == nullptr) return {};
    const Vec3 to = across(nearest->center - agent.position, agent.up);
    const Vec3 away = -1 * across(to, ahead);
    // Dead ahead there is no side: to the left.
    const Vec3 side = norm(away) > 1e-9 * nearest->radius ? away : cross(agent.up, ahead);
    return scaled_to(side, agent.top_speed);
}

Vec3 keep_apart(const Agent& agent, std::span<const Vec3> others, double reach) noexcept {
    Vec3 sum;
    for (const Vec3& other : others) {
        const Vec3 away = across(agent.position - other, agent.up);
        const double off = norm(away);
        if (off > 0 && off < reach) sum += (1 - off / reach) / off * away;
    }
    return at_most(agent.top_speed * sum, agent.top_speed);
}

Vec3 blend(const Agent& agent, std::span<const Wish> wishes) noexcept {
    Vec3 sum;
    double weights = 0;
    for (const Wish& wish : wishes) {
        if (wish.velocity == Vec3{}) continue;
        sum += wish.weight * wish.velocity;
        weights += wish.weight;
    }
    return weights > 0 ? at_most(sum / weights, agent.top_speed) : agent.velocity;
}

Vec3 control(const Agent& agent, const Vec3& wanted, double response, double strength) noexcept {
    return at_most((wanted - agent.velocity) / response, strength);
}

Vec3 accelerate(const Agent& agent, const Vec3& control, double dt) noexcept {
    return at_most(across(agent.velocity + dt * control, agent.up), agent.top_speed);
}

double caution(double degrees, double distance, double reach, double slowest) noexcept {
    if (!(distance < reach)) return 1;
    const double sharp = std::clamp(degrees / 90, 0.0, 1.0);
    const double near = 1 - std::max(0.0, distance) / reach;
    return 1 - (1 - slowest) * sharp * near;
}

}  // namespace orbweaver::spider
