#include "score.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::inscription {

namespace {

/// The pixels whose middles may lie from `low` to `high`.
std::pair<std::uint32_t, std::uint32_t> pixels_between(double low, double high, std::uint32_t size) {
    const double end = size;
    return {static_cast<std::uint32_t>(std::clamp(std::floor(low), 0.0, end)),
            static_cast<std::uint32_t>(std::clamp(std::ceil(high), 0.0, end))};
}

}  // namespace

int match_score(const Bitmap& source, const Bitmap& target, const Spot& a, const Spot& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return kLeastScore;
    const double ux = dx / length, uy = dy / length, half = 0.5 * kStrip;
    const double reach_x = half * std::abs(uy), reach_y = half * std::abs(ux);
    const auto [left, right] =
        pixels_between(std::min(a.x, b.x) - reach_x, std::max(a.x, b.x) + reach_x, source.width);
    const auto [top, bottom] =
        pixels_between(std::min(a.y, b.y) - reach_y, std::max(a.y, b.y) + reach_y, source.height);
    std::uint32_t source_sum = 0, target_sum = 0;
    for (std::uint32_t y = top; y < bottom; ++y)
        for (std::uint32_t x = left; x < right; ++x) {
            const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
            const double along = px * ux + py * uy, across = py * ux - px * uy;
            if (along < 0 || along > length || std::abs(across) > half) continue;
            source_sum += source.row(y)[x];
            target_sum += target.row(y)[x];
        }
    if (source_sum == 0) return kLeastScore;
    return std::clamp(static_cast<int>(10 * target_sum / source_sum), kLeastScore, kBestScore);
}

}  // namespace orbweaver::inscription
