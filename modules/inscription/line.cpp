#include "line.hpp"

namespace orbweaver::inscription {

void draw_line(Bitmap& bitmap, const Spot& a, const Spot& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const bool steep = std::abs(dy) > std::abs(dx);
    const double from = steep ? a.y : a.x, to = steep ? b.y : b.x;
    const double slope = from == to ? 0 : (steep ? dx / dy : dy / dx);
    const std::uint32_t last = steep ? bitmap.height : bitmap.width;
    const double first = std::max(std::floor(std::min(from, to)), 0.0);
    const double end = std::min(std::floor(std::max(from, to)), static_cast<double>(last) - 1);
    for (double at = first; at <= end; at += 1) {
        const double middle = std::clamp(at + 0.5, std::min(from, to), std::max(from, to));
        const double across = std::floor((steep ? a.x : a.y) + (middle - from) * slope);
        const double x = steep ? across : at, y = steep ? at : across;
        if (x >= 0 && y >= 0 && x < bitmap.width && y < bitmap.height)
            bitmap.row(static_cast<std::uint32_t>(y))[static_cast<std::uint32_t>(x)] = 1;
    }
}

}  // namespace orbweaver::inscription
