#include "places.hpp"

#include <algorithm>
#include <cmath>

#include "footholds.hpp"

namespace orbweaver::spider {

Places::Places(const Surface& surface, const Vec3& gravity, double apart, const RandomStream& random)
    : surface_(surface),
      gravity_(gravity),
      apart_(apart),
      random_(random),
      low_(surface.vertices()[0]),
      high_(low_) {
    for (const Vec3& v : surface.vertices()) {
        low_ = {std::min(low_.x, v.x), std::min(low_.y, v.y), std::min(low_.z, v.z)};
        high_ = {std::max(high_.x, v.x), std::max(high_.y, v.y), std::max(high_.z, v.z)};
    }
}

Places::Found Places::found(const Vec3& point, const Vec3& heading, bool on_front) const noexcept {
    const SurfaceHit hit = surface_.closest_point(point, HUGE_VAL);
    if (hit.answer != Answer::found) return {};
    const Vec3 away = point - surface_.position(hit.at), normal = surface_.normal(hit.at.face);
    const bool behind = !on_front && norm(away) > 1e-9 && dot(away, normal) < 0;
    Found found;
    for (const Vec3& way : {heading, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {  // a wall may lie across the first
        found.place = surface_.place(hit.at, behind ? -1 * normal : normal, way);
        if (found.place.answer == Answer::found) break;
    }
    found.holds = found.place.answer == Answer::found &&
                  holds(surface_.grip(found.place.end.at.face), found.place.end.up, gravity_);
    return found;
}

Places::Found Places::near(const Vec3& point, const Vec3& heading) const noexcept {
    return found(point, heading, false);
}

Places::Found Places::at_random(std::uint64_t number, std::uint64_t count,
                                const std::optional<Vec3>& heading) const {
    constexpr std::uint64_t kTries = 64, kClearTries = 16;
    Found last;
    for (std::uint64_t attempt = 0; attempt < kTries; ++attempt) {
        const std::uint64_t n = 6 * (number + attempt * count);
        const Vec3 point{random_.uniform(n, low_.x, high_.x), random_.uniform(n + 1, low_.y, high_.y),
                         random_.uniform(n + 2, low_.z, high_.z)};
        const Vec3 way{random_.uniform(n + 3, -1, 1), random_.uniform(n + 4, -1, 1),
                       random_.uniform(n + 5, -1, 1)};
        last = found(point, heading.value_or(way), true);
        if (last.holds && (attempt >= kClearTries || is_clear(last.place.end.position))) break;
    }
    return last;
}

void Places::take(const Vec3& position) { taken_.emplace(cell_of(position), position); }

Places::Cell Places::cell_of(const Vec3& position) const noexcept {
    constexpr double kMost = 1e15;  // cells; farther out all share one
    const auto along = [&](double x) {
        return static_cast<std::int64_t>(std::floor(std::clamp(x / apart_, -kMost, kMost)));
    };
    return {along(position.x), along(position.y), along(position.z)};
}

bool Places::is_clear(const Vec3& position) const {
    const Cell middle = cell_of(position);
    for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y) {
            // The three cells along z lie in one stretch.
            const Cell first{middle[0] + x, middle[1] + y, middle[2] - 1};
            const Cell last{first[0], first[1], middle[2] + 1};
            for (auto other = taken_.lower_bound(first); other != taken_.end() && other->first <= last; ++other)
                if (distance(other->second, position) < apart_) return false;
        }
    return true;
}

}  // namespace orbweaver::spider
