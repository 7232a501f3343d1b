#include "orbweaver/gaussian_blur.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "orbweaver/exact_math.hpp"

namespace orbweaver {

namespace {

/// Half of a Gaussian, from its middle on; all of it sums to 1.
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

/// out[x] += factor * (one[x] + other[x])
void add(const float* one, const float* other, float factor, float* out, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) out[x] += factor * (one[x] + other[x]);
}

}  // namespace

void gaussian_blur(std::span<float> values, std::size_t width, std::size_t height, double sigma) {
    const std::vector<float> kernel = half_kernel(sigma);
    const std::size_t reach = kernel.size() - 1;
    std::vector<float> along(values.size());
    std::vector<float> padded(width + 2 * reach);
    for (std::size_t y = 0; y < height; ++y) {
        const float* row = values.data() + y * width;
        float* out = along.data() + y * width;
        std::fill_n(padded.begin(), reach, row[0]);
        std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(reach));
        std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(reach), reach, row[width - 1]);
        const float* middle = padded.data() + reach;
        for (std::size_t x = 0; x < width; ++x) out[x] = kernel[0] * middle[x];
        for (std::size_t k = 1; k <= reach; ++k) add(middle - k, middle + k, kernel[k], out, width);
    }
    for (std::size_t y = 0; y < height; ++y) {
        float* out = values.data() + y * width;
        const auto row = [&](std::size_t at) { return along.data() + at * width; };
        for (std::size_t x = 0; x < width; ++x) out[x] = kernel[0] * row(y)[x];
        for (std::size_t k = 1; k <= reach; ++k)
            add(row(y > k ? y - k : 0), row(std::min(y + k, height - 1)), kernel[k], out, width);
    }
}

}  // namespace orbweaver
