#include "low_pass.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/exact_math.hpp"

namespace orbweaver::inscription {

namespace {

/// Half of a Gaussian, from its middle to four standard deviations; all of it sums to 1.
std::vector<float> half_kernel(double sigma) {
    const auto reach = static_cast<std::size_t>(std::ceil(4 * sigma));
    std::vector<double> exact(reach + 1);
    double sum = 0;
    for (std::size_t i = 0; i <= reach; ++i) {
        const double d = static_cast<double>(i) / sigma;
        exact[i] = exponential(-0.5 * d * d);
        sum += i == 0 ? exact[i] : 2 * exact[i];
    }
    std::vector<float> kernel(reach + 1);
    for (std::size_t i = 0; i <= reach; ++i) kernel[i] = static_cast<float>(exact[i] / sum);
    return kernel;
}

/// The pixel `by` before or behind `at`, or the edge.
std::uint32_t before(std::uint32_t at, std::size_t by) {
    return by > at ? 0 : at - static_cast<std::uint32_t>(by);
}
std::uint32_t behind(std::uint32_t at, std::size_t by, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::min<std::size_t>(at + by, size - 1));
}

}  // namespace

Shades low_pass(const Shades& shades, double sigma) {
    const std::vector<float> kernel = half_kernel(sigma);
    const std::uint32_t width = shades.width, height = shades.height;
    Shades along(width, height);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const float* row = shades.row(y);
            float sum = kernel[0] * row[x];
            for (std::size_t k = 1; k < kernel.size(); ++k)
                sum += kernel[k] * (row[before(x, k)] + row[behind(x, k, width)]);
            along.row(y)[x] = sum;
        }
    Shades blurred(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        float* out = blurred.row(y);
        for (std::uint32_t x = 0; x < width; ++x) out[x] = kernel[0] * along.row(y)[x];
        for (std::size_t k = 1; k < kernel.size(); ++k) {
            const float* above = along.row(before(y, k));
            const float* below = along.row(behind(y, k, height));
            for (std::uint32_t x = 0; x < width; ++x) out[x] += kernel[k] * (above[x] + below[x]);
        }
    }
    return blurred;
}

}  // namespace orbweaver::inscription
