#include "thread_parts.hpp"

#include <cmath>

#include "line.hpp"

namespace orbweaver::inscription {

std::vector<Part> dark_parts(const Bitmap& bitmap, const Spot& a, const Spot& b, double shortest) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return {};
    const double least = shortest / length;
    std::vector<Part> parts;
    double dark = 0;
    const auto snap = [&](Part part) {
        if (part.from < least) part.from = 0;
        if (part.to > 1 - least) part.to = 1;
        return part;
    };
    cut_at_pixels(bitmap.width, bitmap.height, a, b,
                  [&](std::uint32_t x, std::uint32_t y, double from, double to) {
                      if (bitmap.row(y)[x] == 0) return;
                      dark += to - from;
                      if (!parts.empty() && from - parts.back().to < least)
                          parts.back().to = to;
                      else
                          parts.push_back({from, to});
                  });
    if (1 < 2 * least) {
        if (dark >= 0.5) return {{0, 1}};
        return {};
    }
    for (Part& part : parts) part = snap(part);
    std::erase_if(parts, [&](const Part& part) { return part.to - part.from < least; });
    return parts;
}

}  // namespace orbweaver::inscription
