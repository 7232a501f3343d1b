#include "otsu.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace orbweaver::inscription {

Histogram histogram(const Shades& shades) {
    Histogram counts{};
    for (const float shade : shades.values)
        ++counts[static_cast<std::size_t>(std::lround(255 * std::clamp(shade, 0.0F, 1.0F)))];
    return counts;
}

std::optional<std::uint32_t> otsu_level(const Histogram& histogram) {
    double all = 0, moment = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        all += static_cast<double>(histogram[i]);
        moment += static_cast<double>(i) * static_cast<double>(histogram[i]);
    }
    double below = 0, below_moment = 0, best = 0;
    std::uint32_t first = 0, last = 0;
    for (std::uint32_t level = 0; level < histogram.size(); ++level) {
        below += static_cast<double>(histogram[level]);
        below_moment += level * static_cast<double>(histogram[level]);
        if (below == 0 || below == all) continue;
        const double difference = below_moment / below - (moment - below_moment) / (all - below);
        const double between = below * (all - below) * difference * difference;
        if (between > best) {
            best = between;
            first = last = level;
        } else if (between == best && level == last + 1) {
            last = level;
        }
    }
    if (best == 0) return std::nullopt;
    return (first + last) / 2;
}

std::optional<double> otsu_threshold(const Shades& shades) {
    const auto level = otsu_level(histogram(shades));
    if (!level) return std::nullopt;
    return (*level + 0.5) / 255;
}

}  // namespace orbweaver::inscription
