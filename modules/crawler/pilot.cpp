#include "pilot.hpp"

#include <algorithm>

#include "orbweaver/polyline.hpp"

namespace orbweaver::crawler {

namespace {

double ease_at(const Crawler& crawler, double time) noexcept {
    const double begun = std::min(1.0, time / crawler.period);
    return begun * begun * (3 - 2 * begun);
}

Effort effort_at(const Crawler& crawler, double time, double turn) noexcept {
    const double ease = ease_at(crawler, time);
    const Effort& full = crawler.effort;
    return {ease * full.strain, ease * full.bend, ease * full.lift, turn * full.turn};
}

}  // namespace

Pose heading_of(const Lattice& lattice, std::span<const Vec3> points, const Vec3& center) noexcept {
    const std::uint32_t half = lattice.rings() / 2;
    Vec3 rear, front, up;
    for (std::uint32_t ring = 0; ring < lattice.rings(); ++ring) {
        const Vec3* corners = &points[std::size_t{kCorners} * ring];
        if (ring < half) rear += ring_middle(corners);
        if (ring >= lattice.rings() - half) front += ring_middle(corners);
        up += corners[2] + corners[3] - corners[0] - corners[1];
    }
    const Vec3 along = front - rear;
    const double length = norm(along);
    const Vec3 forward = length > 0 ? along / length : Vec3{1, 0, 0};
    up = across(up, forward);
    const double height = norm(up);
    return {center, forward, height > 0 ? up / height : Vec3{0, 1, 0}};
}

Command own_command(const Crawler& crawler, const Pose& heading) noexcept {
    if (!crawler.seek && !crawler.path) return {};
    const Vec3 aim =
        crawler.seek
            ? *crawler.seek
            : ahead_on(crawler.path->points, crawler.path->loop, heading.middle, crawler.path->ahead).point;
    return {1, turn_towards(heading.middle, heading.forward, heading.up, aim)};
}

Drive go_on(const Crawler& crawler, const Command& command, double time, double step, Pilot& pilot) noexcept {
    const Pilot before = pilot;
    pilot.cycles += command.pace * step / crawler.period;
    pilot.turn += std::min(1.0, step / crawler.period) * (command.turn - pilot.turn);
    return {{before.cycles, pilot.cycles},
            {effort_at(crawler, time, before.turn), effort_at(crawler, time + step, pilot.turn)},
            {ease_at(crawler, time), ease_at(crawler, time + step)}};
}

Drive hold(const Crawler& crawler, const Pilot& pilot, double time) noexcept {
    const Effort effort = effort_at(crawler, time, pilot.turn);
    const double ease = ease_at(crawler, time);
    return {{pilot.cycles, pilot.cycles}, {effort, effort}, {ease, ease}};
}

}  // namespace orbweaver::crawler
