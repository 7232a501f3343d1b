#include "orbweaver/gaussian_blur.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace orbweaver;

// Cut at four standard deviations, a Gaussian lacks 6e-5; single precision adds 1e-6.
TEST_CASE("a point becomes a Gaussian of the deviation that was asked for", "[unit]") {
    for (const double sigma : {0.7, 2.0, 5.0}) {
        constexpr std::size_t kSide = 61;
        std::vector<float> blurred(kSide * kSide);
        blurred[30 * kSide + 30] = 1;
        gaussian_blur(blurred, kSide, kSide, sigma);
        double norm = 0;
        for (int k = -100; k <= 100; ++k) norm += std::exp(-0.5 * k * k / (sigma * sigma));
        double sum = 0;
        for (std::size_t y = 0; y < kSide; ++y)
            for (std::size_t x = 0; x < kSide; ++x) {
                const double dx = static_cast<double>(x) - 30, dy = static_cast<double>(y) - 30;
                const double expected = std::exp(-0.5 * (dx * dx + dy * dy) / (sigma * sigma)) / (norm * norm);
                CHECK(blurred[y * kSide + x] == Approx(expected).margin(2e-4 / (norm * norm) + 1e-7));
                sum += blurred[y * kSide + x];
            }
        CHECK(sum == Approx(1).margin(1e-5));
    }
}

TEST_CASE("one shade stays what it is up to the edges, also where the blur is wider than the picture",
          "[unit]") {
    for (const double sigma : {0.5, 3.0, 40.0}) {
        std::vector<float> gray(9 * 4, 0.25F);
        gaussian_blur(gray, 9, 4, sigma);
        for (const float shade : gray) CHECK(shade == Approx(0.25).margin(1e-5));
    }
}
