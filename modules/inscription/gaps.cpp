#include "gaps.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/random.hpp"

namespace orbweaver::inscription {

namespace {

struct Disc {
    double x, y, radius;  ///< pixels
};

/// Darkens the pixels whose centres lie in the disc; returns how many were bright.
std::uint64_t darken(Bitmap& bitmap, const Disc& disc) {
    const auto within = [](double at, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::clamp(at, 0.0, static_cast<double>(size)));
    };
    std::uint64_t fresh = 0;
    const std::uint32_t end = within(disc.y + disc.radius + 1, bitmap.height);
    for (std::uint32_t y = within(disc.y - disc.radius, bitmap.height); y < end; ++y) {
        const double dy = y + 0.5 - disc.y;
        const double rest = disc.radius * disc.radius - dy * dy;
        if (rest < 0) continue;
        const double half = std::sqrt(rest);
        const std::uint32_t last = within(disc.x + half + 0.5, bitmap.width);
        for (std::uint32_t x = within(std::ceil(disc.x - half - 0.5), bitmap.width); x < last; ++x) {
            std::uint8_t& pixel = bitmap.row(y)[x];
            fresh += 1 - pixel;
            pixel = 1;
        }
    }
    return fresh;
}

}  // namespace

Bitmap random_gaps(std::uint32_t width, std::uint32_t height, double density, std::uint64_t seed) {
    Bitmap bitmap(width, height);
    const RandomStream random(seed, "gaps");
    const double side = std::min(width, height);
    const double wanted = density * static_cast<double>(bitmap.values.size());
    std::uint64_t dark = 0;
    for (std::uint64_t n = 0; static_cast<double>(dark) < wanted; n += 3)
        dark += darken(bitmap, {random.uniform(n, 0, width), random.uniform(n + 1, 0, height),
                                side * random.uniform(n + 2, 0.007, 0.02)});
    return bitmap;
}

}  // namespace orbweaver::inscription
