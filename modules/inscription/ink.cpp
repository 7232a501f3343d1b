#include "ink.hpp"

#include <cmath>

#include "line.hpp"

namespace orbweaver::inscription {

Shades ink(std::span<const Vec3> points, std::span<const ThreadSegment> segments, const Page& page) {
    Shades seen(page.side, page.side);
    for (const ThreadSegment& thread : segments) {
        const Spot a = page.spot(points[thread.a]), b = page.spot(points[thread.b]);
        const double silk = std::hypot(b.x - a.x, b.y - a.y) * thread.width;
        cut_at_pixels(page.side, page.side, a, b,
                      [&](std::uint32_t x, std::uint32_t y, double from, double to) {
                          seen.row(y)[x] += static_cast<float>((to - from) * silk);
                      });
    }
    return seen;
}

}  // namespace orbweaver::inscription
