#include "sky.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "orbweaver/fault.hpp"

using namespace orbweaver;

namespace {

/// Mean shade of one channel over a window of the picture given in fractions of its sides.
double mean(const picture::Picture& p, int channel, double x0, double x1, double y0, double y1) {
    double sum = 0;
    int count = 0;
    for (int y = static_cast<int>(y0 * p.height); y < static_cast<int>(y1 * p.height); ++y) {
        for (int x = static_cast<int>(x0 * p.width); x < static_cast<int>(x1 * p.width); ++x, ++count)
            sum += p.rgb[static_cast<std::size_t>(3 * (y * p.width + x) + channel)];
    }
    return sum / count;
}

}  // namespace

TEST_CASE("a sky is a function of its recipe", "[unit]") {
    CHECK(make_sky({64, 32, 1}).rgb == make_sky({64, 32, 1}).rgb);
    CHECK(make_sky({64, 32, 1}).rgb != make_sky({64, 32, 2}).rgb);
}

TEST_CASE("blue above, green below, and dark enough in the middle for pale threads", "[image]") {
    const auto sky = make_sky({256, 128, 1});
    CHECK(mean(sky, 2, 0, 1, 0, 0.3) > 1.3 * mean(sky, 0, 0, 1, 0, 0.3));
    CHECK(mean(sky, 1, 0, 1, 0.55, 1) > 1.2 * mean(sky, 2, 0, 1, 0.55, 1));
    for (int channel = 0; channel < 3; ++channel) CHECK(mean(sky, channel, 0.46, 0.54, 0.42, 0.58) < 130);
}

TEST_CASE("the picture closes behind the viewer", "[image]") {
    const auto sky = make_sky({512, 256, 1});
    double step = 0;
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t c = 0; c < 3; ++c)
            step += std::abs(sky.rgb[3 * 512 * y + c] - sky.rgb[3 * (512 * y + 511) + c]);
    CHECK(step / (3 * 256) < 6);  // shades, mean; within the picture neighbors differ by about 3
}

TEST_CASE("sizes out of range are refused in words", "[extreme]") {
    CHECK_THROWS_WITH(make_sky({8, 4, 1}),
                      "A sky of 8 x 4 pixels was asked for; each side must be from 16 to 16384.");
    CHECK_THROWS_AS(make_sky({40000, 20000, 1}), Fault);
}
