#include "line.hpp"

namespace orbweaver::inscription {

void draw_line(Bitmap& bitmap, const Spot& a, const Spot& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const bool steep = std::abs(dy) > std::abs(dx);
    const double from = steep ? a.y : a.x, to = steep ? b.y : b.x;
    const double slope = from == to ? 0 : (steep ? dx / dy : dy / dx);
    const std::uint32_t last = steep ? bitmap.height : bitmap.width;
    const auto [low, high] = std::minmax(from, to);
    const auto pixel = [&](double at) { return static_cast<std::uint32_t>(std::clamp<double>(at, 0, last)); };
    for (std::uint32_t at = pixel(std::floor(low)), end = pixel(std::floor(high) + 1); at < end; ++at) {
        const double middle = std::clamp(at + 0.5, low, high);
        const double across = std::floor((steep ? a.x : a.y) + (middle - from) * slope);
        if (across < 0 || across >= (steep ? bitmap.width : bitmap.height)) continue;
        const auto aside = static_cast<std::uint32_t>(across);
        (steep ? bitmap.row(at)[aside] : bitmap.row(aside)[at]) = 1;
    }
}

}  // namespace orbweaver::inscription
