#include "orbweaver/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver {

PointAhead ahead_on(std::span<const Vec3> points, bool loop, const Vec3& position, double ahead) noexcept {
    const std::size_t count = points.size(), pieces = loop ? count : count - 1;
    const auto corner = [&](std::size_t i) { return points[i % count]; };
    std::size_t nearest = 0;
    double share = 0, least = std::numeric_limits<double>::infinity(), around = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Vec3 way = corner(i + 1) - corner(i);
        const double square = dot(way, way);
        const double here = square > 0 ? std::clamp(dot(position - corner(i), way) / square, 0.0, 1.0) : 0;
        const double off = distance(corner(i) + here * way, position);
        around += std::sqrt(square);
        if (off >= least) continue;
        least = off;
        nearest = i;
        share = here;
    }
    if (!(around > 0)) return {points.back(), true};
    double left = loop && ahead > around ? std::fmod(ahead, around) : ahead;
    // The piece it begins on comes once more, where a loop leads back to its beginning.
    for (std::size_t taken = 0; taken <= pieces && (loop || nearest < pieces); ++taken, ++nearest, share = 0) {
        const Vec3 from = corner(nearest), to = corner(nearest + 1);
        const double length = distance(from, to), rest = (1 - share) * length;
        if (left <= rest && length > 0) return {from + (share + left / length) * (to - from)};
        left -= rest;
    }
    return {points.back(), true};
}

}  // namespace orbweaver
