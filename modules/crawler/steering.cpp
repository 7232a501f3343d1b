#include "steering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::crawler {

std::optional<Command> command_at(std::span<const TimedCommand> script, double time) noexcept {
    constexpr double kRounding = 1e-9;  // s
    std::optional<Command> command;
    for (const TimedCommand& each : script)
        if (each.begin <= time + kRounding && time + kRounding < each.end) command = each.command;
    return command;
}

Vec3 aim_along(const Path& path, const Vec3& position) noexcept {
    const std::size_t count = path.points.size(), pieces = path.loop ? count : count - 1;
    const auto corner = [&](std::size_t i) { return path.points[i % count]; };
    if (pieces == 0) return path.points.front();
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity(), share = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Vec3 way = corner(i + 1) - corner(i);
        const double square = dot(way, way);
        const double at = square > 0 ? std::clamp(dot(position - corner(i), way) / square, 0.0, 1.0) : 0;
        const double far = distance(position, corner(i) + at * way);
        if (far < least) least = far, nearest = i, share = at;
    }
    double left = path.ahead;
    for (std::size_t taken = 0; taken <= 2 * pieces; ++taken) {
        const std::size_t i = (nearest + taken) % pieces;
        const Vec3 way = corner(i + 1) - corner(i);
        const double length = norm(way), rest = (1 - share) * length;
        if (left <= rest && length > 0) return corner(i) + (share + left / length) * way;
        if (!path.loop && i + 1 == pieces) break;
        left -= rest;
        share = 0;
    }
    return corner(path.loop ? nearest : pieces);
}

double turn_towards(const Vec3& position, const Vec3& forward, const Vec3& up, const Vec3& aim) noexcept {
    constexpr double kGain = 2;  // turned as far as it can at 30 degrees
    const Vec3 way = across(aim - position, up);
    const double far = norm(way);
    if (!(far > 0)) return 0;
    const double left = dot(way, cross(up, forward)) / far;
    if (dot(way, forward) <= 0) return left < 0 ? -1 : 1;
    return std::clamp(kGain * left, -1.0, 1.0);
}

}  // namespace orbweaver::crawler
