#include "noise.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;

TEST_CASE("noise is smooth, within its range, and a function of its seed", "[unit]") {
    const Noise noise(5);
    double low = 1;
    double high = 0;
    double jump = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p{0.01 * i, -0.003 * i, 7.5};
        const double v = noise.fractal(p, 4);
        low = std::min(low, v);
        high = std::max(high, v);
        jump = std::max(jump, std::abs(noise.fractal(p + Vec3{1e-4, 0, 0}, 4) - v));
    }
    CHECK(low >= 0);
    CHECK(high <= 1);
    CHECK(high - low > 0.5);
    CHECK(jump < 1e-3);
    CHECK(noise.value({0.3, 0.4, 0.5}) == Noise(5).value({0.3, 0.4, 0.5}));
    CHECK(noise.value({0.3, 0.4, 0.5}) != Noise(6).value({0.3, 0.4, 0.5}));
}
