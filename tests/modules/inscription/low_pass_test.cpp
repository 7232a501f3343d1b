#include "low_pass.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::inscription;

// Cut at four standard deviations, a Gaussian lacks 6e-5; single precision adds 1e-6.
TEST_CASE("a point becomes a Gaussian of the deviation that was asked for", "[unit]") {
    for (const double sigma : {0.7, 2.0, 5.0}) {
        Shades point(61, 61);
        point.row(30)[30] = 1;
        const Shades blurred = low_pass(point, sigma);
        double norm = 0;
        for (int k = -100; k <= 100; ++k) norm += std::exp(-0.5 * k * k / (sigma * sigma));
        double sum = 0;
        for (std::uint32_t y = 0; y < 61; ++y)
            for (std::uint32_t x = 0; x < 61; ++x) {
                const double dx = x - 30.0, dy = y - 30.0;
                const double expected = std::exp(-0.5 * (dx * dx + dy * dy) / (sigma * sigma)) / (norm * norm);
                CHECK(blurred.row(y)[x] == Approx(expected).margin(2e-4 / (norm * norm) + 1e-7));
                sum += blurred.row(y)[x];
            }
        CHECK(sum == Approx(1).margin(1e-5));
    }
}

TEST_CASE("one shade stays what it is up to the edges, also where the blur is wider than the picture",
          "[unit]") {
    Shades gray(9, 4);
    gray.values.assign(gray.values.size(), 0.25F);
    for (const double sigma : {0.5, 3.0, 40.0})
        for (const float shade : low_pass(gray, sigma).values) CHECK(shade == Approx(0.25).margin(1e-5));
}
