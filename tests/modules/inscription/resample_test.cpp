#include "resample.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

ByteShades random_picture(std::uint32_t width, std::uint32_t height) {
    ByteShades picture(width, height);
    const RandomStream random(1, "picture");
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = static_cast<std::uint8_t>(random.bits(i));
    return picture;
}

}  // namespace

TEST_CASE("the same size gives the same shades", "[unit]") {
    const ByteShades picture = random_picture(31, 17);
    const Shades same = resample(picture, 31, 17);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        CHECK(same.values[i] == static_cast<float>(picture.values[i]) / 255);
}

// Single precision, sums of less than 100 terms: 1e-5 is ten times their rounding.
TEST_CASE("one shade stays what it is at every size", "[unit]") {
    ByteShades picture(13, 29);
    picture.values.assign(picture.values.size(), 51);
    const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{1, 1}, {5, 200}, {100, 3}, {13, 29}, {1, 90}};
    for (const auto& [width, height] : sizes)
        for (const float shade : resample(picture, width, height).values)
            CHECK(shade == Approx(0.2).margin(1e-5));
}

TEST_CASE("a ramp stays a ramp where it shrinks and where it grows", "[unit]") {
    ByteShades ramp(200, 2);
    for (std::uint32_t i = 0; i < 400; ++i) ramp.values[i] = static_cast<std::uint8_t>(i % 200);
    for (const std::uint32_t width : {50u, 400u}) {
        const Shades resampled = resample(ramp, width, 1);
        const double ratio = 200.0 / width, edge = std::max(1.0, ratio) / ratio;
        for (std::uint32_t x = 0; x < width; ++x) {
            if (x < edge || x + 1 + edge > width) continue;  // there the triangle is cut
            CHECK(255 * resampled.values[x] == Approx((x + 0.5) * ratio - 0.5).margin(1e-3));
        }
    }
}

TEST_CASE("what lies between samples is not lost where a picture shrinks", "[unit]") {
    ByteShades line(1000, 10);
    line.values.assign(line.values.size(), 255);
    for (std::uint32_t y = 0; y < 10; ++y) line.row(y)[333] = 0;
    const Shades small = resample(line, 20, 10);
    const double dark = std::accumulate(small.values.begin(), small.values.end(), 0.0,
                                        [](double sum, float v) { return sum + 1 - v; });
    CHECK(dark == Approx(10.0 / 50).epsilon(1e-4));  // one column of fifty in each of ten rows
}
