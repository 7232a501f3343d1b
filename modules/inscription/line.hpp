#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "page.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// Darkens a line one pixel wide: one pixel of each column, or of each row where it is steep, as far as it lies
/// on the raster.
void draw_line(Bitmap& bitmap, const Spot& a, const Spot& b);

/// Cuts a line at the sides of pixels, and calls visit(x, y, from, to) with the pixel of each piece, of a
/// raster of that size, and where it begins and ends, as shares of the line; pieces beside the raster are left
/// out.
template <class Visit>
void cut_at_pixels(std::uint32_t width, std::uint32_t height, const Spot& a, const Spot& b, Visit&& visit) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    if (dx == 0 && dy == 0) return;
    const auto next_crossing = [](double from, double way, double at) {
        if (way == 0) return 2.0;  // never before the end, which is at 1
        const double here = from + way * at;
        const double side = way > 0 ? std::floor(here + 1e-9) + 1 : std::ceil(here - 1e-9) - 1;
        return (side - from) / way;
    };
    double at = 0;
    while (at < 1) {
        const double next = std::min({next_crossing(a.x, dx, at), next_crossing(a.y, dy, at), 1.0});
        const double middle = 0.5 * (at + next), x = std::floor(a.x + middle * dx),
                     y = std::floor(a.y + middle * dy);
        if (x >= 0 && y >= 0 && x < width && y < height)
            visit(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), at, next);
        if (!(next > at)) return;
        at = next;
    }
}

}  // namespace orbweaver::inscription
