#include "resample.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::inscription {

namespace {

/// What one new pixel takes of old ones: weights that sum to 1, from `first` on.
struct Taps {
    std::uint32_t first = 0;
    std::vector<float> weights;
};

std::vector<Taps> taps_of(std::uint32_t from, std::uint32_t to) {
    const double ratio = static_cast<double>(from) / to;
    const double reach = std::max(ratio, 1.0);
    std::vector<Taps> all(to);
    for (std::uint32_t i = 0; i < to; ++i) {
        const double center = (i + 0.5) * ratio - 0.5;
        const auto first = static_cast<std::uint32_t>(std::max(0.0, std::floor(center - reach) + 1));
        const auto last = static_cast<std::uint32_t>(std::min(from - 1.0, std::ceil(center + reach) - 1));
        double sum = 0;
        for (std::uint32_t k = first; k <= last; ++k) sum += reach - std::abs(k - center);
        all[i].first = first;
        for (std::uint32_t k = first; k <= last; ++k)
            all[i].weights.push_back(static_cast<float>((reach - std::abs(k - center)) / sum));
    }
    return all;
}

}  // namespace

Shades resample(const ByteShades& picture, std::uint32_t width, std::uint32_t height) {
    const auto across = taps_of(picture.width, width);
    Shades narrow(width, picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::uint8_t* from = picture.row(y) + across[x].first;
            float sum = 0;
            for (const float weight : across[x].weights) sum += weight * static_cast<float>(*from++);
            narrow.row(y)[x] = sum / 255;
        }
    const auto down = taps_of(picture.height, height);
    Shades result(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::size_t k = 0; k < down[y].weights.size(); ++k) {
            const float* from = narrow.row(down[y].first + static_cast<std::uint32_t>(k));
            for (std::uint32_t x = 0; x < width; ++x) result.row(y)[x] += down[y].weights[k] * from[x];
        }
    return result;
}

}  // namespace orbweaver::inscription
