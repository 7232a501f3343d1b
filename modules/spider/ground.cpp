#include "ground.hpp"

#include <algorithm>
#include <array>

#include "unit.hpp"
#include "up_turn.hpp"

namespace orbweaver::spider {
namespace {

/// A vector that lies in one footing's plane, as the same in another's.
Vec3 carried(const Vec3& v, const Footing& from, const Footing& to) noexcept {
    const Vec3 left = cross(from.up, from.forward), other_left = cross(to.up, to.forward);
    return dot(v, from.forward) * to.forward + dot(v, left) * other_left;
}

/// Where a stride in that direction ends; the ground itself where there is no answer.
SurfaceStride feel_along(const Surface& surface, const Ground& ground, const Vec3& way, double reach,
                         std::span<StrideCorner> corners) noexcept {
    SurfaceStride stride = stride_along(surface, ground.footing, way, reach, corners);
    if (stride.step.answer != Answer::found) stride.step.end = ground.footing;
    return stride;
}

/// Whether a body finds room there.
bool has_headroom(const Surface& surface, const Footing& there, double headroom) noexcept {
    constexpr double kOff = 1e-3;  // of it, so that the ray does not begin in the ground
    const Vec3 start = next_to(surface, there, kOff * headroom);
    return surface.first_hit({start, there.up, headroom}).answer != Answer::found;
}

/// Whether a body would come to a ceiling there: not to the other side of a corner of 50 degrees and more, on
/// which it goes on and has room again.
bool is_too_low(const Surface& surface, const Footing& there, double headroom) noexcept {
    constexpr double kThrough = 3;       // times the headroom
    constexpr double kSharpest = -0.64;  // cosine of what the up turns by
    if (has_headroom(surface, there, headroom)) return false;
    std::array<StrideCorner, 4> corners;
    const SurfaceStride on = surface.stride(there, kThrough * headroom, corners);
    const auto turns_over = [](const StrideCorner& corner) {
        const double cosine = dot(corner.up_before, corner.up_after);
        return corner.rises && cosine < 0 && cosine > kSharpest;
    };
    const std::size_t met = std::min<std::size_t>(on.corners, corners.size());
    return std::none_of(corners.begin(), corners.begin() + met, turns_over) ||
           !has_headroom(surface, on.step.end, headroom);
}

}  // namespace

Vec3 next_to(const Surface& surface, const Footing& ground, double off) noexcept {
    constexpr double kIn = 4;         // times as far into the face as above it
    constexpr double kSharpest = 10;  // times as far from the edges: of a crease of 6 degrees and more
    const auto& corners = surface.faces()[ground.at.face];
    const Vec3 &a = surface.vertices()[corners[0]], &b = surface.vertices()[corners[1]],
               &c = surface.vertices()[corners[2]];
    const Vec3 in = (a + b + c) / 3 - ground.position;
    const double far = norm(in), share = far > 0 ? std::min(1.0, kIn * off / far) : 1;
    // Of a place so far in, each weight is at least a third of the share.
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const double from_edges = share / 3 * norm(cross(b - a, c - a)) / longest;
    return ground.position + share * in + std::min(off, from_edges / kSharpest) * ground.up;
}

SurfaceStride stride_along(const Surface& surface, Footing ground, const Vec3& way, double length,
                           std::span<StrideCorner> corners) noexcept {
    ground.forward = way;
    return surface.stride(ground, length, corners);
}

MoveEnd move(const Surface& surface, double dt, double headroom, Vec3 way, Ground& ground) noexcept {
    constexpr double kStill = 1e-7;  // m/s: who has come to an edge does not go to and fro over it for ever
    const double speed = norm(way);
    if (speed < kStill) return MoveEnd::moved;
    Footing from = ground.footing;
    from.forward = way / speed;
    const SurfaceStep step = surface.stride(from, speed * dt, {}).step;
    if (step.answer != Answer::found) return MoveEnd::lost;
    if (is_too_low(surface, step.end, headroom) && has_headroom(surface, from, headroom)) {
        ground.velocity = -1 * ground.velocity;
        return MoveEnd::turned;
    }
    ground.facing = unit_or(carried(ground.facing, from, step.end), step.end.forward);
    ground.velocity = carried(ground.velocity, from, step.end);
    ground.footing = step.end;
    if (step.stop == StepStop::none) return MoveEnd::moved;
    ground.velocity = -1 * ground.velocity;
    return MoveEnd::turned;
}

void face_ahead(double most_degrees, Ground& ground) noexcept {
    const double speed = norm(ground.velocity);
    const Vec3 facing = unit_or(across(ground.facing, ground.footing.up), ground.footing.forward);
    ground.facing = facing;
    if (speed == 0) return;
    const Vec3 wanted = unit_or(across(ground.velocity, ground.footing.up), facing);
    ground.facing = turned_about(ground.footing.up, facing, wanted, most_degrees);
}

Feel feel_ahead(const Surface& surface, const Ground& ground, double reach, double headroom) noexcept {
    std::array<StrideCorner, 4> corners;
    const SurfaceStride ahead = feel_along(surface, ground, ground.facing, reach, corners);
    const SurfaceStride behind = feel_along(surface, ground, -1 * ground.facing, reach, {});
    const Vec3& here = ground.footing.up;
    Feel feel;
    feel.up = unit_or(ahead.step.end.up + here + behind.step.end.up, here);
    feel.corner_distance = feel.border_distance = reach * 2;
    const bool ends = ahead.step.stop == StepStop::border;
    if (ends || !has_headroom(surface, ahead.step.end, headroom)) {
        const Vec3 left = cross(here, ground.facing);
        feel.border_distance = ends ? ahead.step.walked : reach / 2;
        feel.room_left = feel_along(surface, ground, ground.facing + left, reach, {}).step.walked;
        feel.room_right = feel_along(surface, ground, ground.facing - left, reach, {}).step.walked;
    }
    if (ahead.corners == 0) return feel;
    const StrideCorner& first = corners[0];
    feel.corner_distance = first.distance;
    feel.corner_degrees = degrees_between(first.up_before, first.up_after);
    feel.rises = first.rises;
    const Vec3 along = unit_or(cross(first.up_before, first.up_after));
    feel.corner_along = dot(along, ground.facing) < 0 ? -1 * along : along;
    return feel;
}

}  // namespace orbweaver::spider
