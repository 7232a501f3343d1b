#include "otsu.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// Variance between the classes "level and below" and "above", from the definition: means of every pixel.
double variance_between(const Histogram& histogram, std::size_t level) {
    double counts[2] = {}, moments[2] = {};
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        const std::size_t part = i <= level ? 0 : 1;
        counts[part] += static_cast<double>(histogram[i]);
        moments[part] += static_cast<double>(i) * static_cast<double>(histogram[i]);
    }
    if (counts[0] == 0 || counts[1] == 0) return 0;
    const double all = counts[0] + counts[1], mean = (moments[0] + moments[1]) / all;
    double sum = 0;
    for (const std::size_t part : {0, 1}) {
        const double d = moments[part] / counts[part] - mean;
        sum += counts[part] / all * d * d;
    }
    return sum;
}

Histogram random_histogram(std::uint64_t seed) {
    Histogram histogram{};
    const RandomStream random(seed, "histogram");
    const std::size_t shades = 2 + random.bits(0) % 200;
    for (std::size_t n = 1; n <= shades; ++n)
        histogram[random.bits(2 * n) % 256] += 1 + random.bits(2 * n + 1) % 1000;
    return histogram;
}

}  // namespace

// Both add up at most 256 terms: rounding is below 1e-13 of the variance.
TEST_CASE("no level parts the shades better than Otsu's", "[unit]") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Histogram histogram = random_histogram(seed);
        double best = 0;
        for (std::size_t level = 0; level < 256; ++level)
            best = std::max(best, variance_between(histogram, level));
        if (best == 0) continue;  // one shade
        const auto level = otsu_level(histogram);
        REQUIRE(level);
        CHECK(variance_between(histogram, *level) == Approx(best).epsilon(1e-12));
    }
}

TEST_CASE("two shades are parted halfway between", "[unit]") {
    Histogram histogram{};
    histogram[20] = 5;
    histogram[220] = 1000;
    CHECK(otsu_level(histogram) == 119);
    Shades shades(2, 1);
    shades.values = {0, 1};
    CHECK(otsu_threshold(shades) == Approx(127.5 / 255).margin(1e-15));
}

TEST_CASE("one shade cannot be parted", "[unit]") {
    Shades shades(5, 5);
    CHECK_FALSE(otsu_threshold(shades));
    shades.values.assign(25, 1);
    CHECK_FALSE(otsu_threshold(shades));
}
