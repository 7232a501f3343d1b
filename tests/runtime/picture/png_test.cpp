#include "picture/png.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "orbweaver/fault.hpp"
#include "picture/decode.hpp"
#include "scratch.hpp"

using namespace orbweaver;

namespace {

std::vector<std::uint8_t> gradient(int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int c : {x * 3, y * 5, x * y}) rgb.push_back(static_cast<std::uint8_t>(c));
    return rgb;
}

std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

TEST_CASE("a PNG gives back the pixels it was made of", "[unit]") {
    const test::Scratch scratch;
    for (const auto effort : {picture::PngEffort::fast, picture::PngEffort::small}) {
        const auto [width, height] = GENERATE(std::pair{1, 1}, std::pair{7, 3}, std::pair{257, 129});
        const auto rgb = gradient(width, height);
        const auto file = scratch.write("a.png", text(picture::encode_png(width, height, rgb, effort)));
        const auto back = picture::decode(file);
        CHECK(back.width == width);
        CHECK(back.height == height);
        CHECK(back.rgb == rgb);
    }
}

TEST_CASE("a PNG says that it is sRGB", "[unit]") {
    CHECK(text(picture::encode_png(2, 2, gradient(2, 2))).find("sRGB") != std::string::npos);
}

TEST_CASE("sizes that contradict the pixels are refused", "[extreme]") {
    CHECK_THROWS_WITH(picture::encode_png(3, 3, gradient(2, 2)),
                      "A picture to be written as PNG has 12 bytes, which is not 3 x 3 x 3.");
    CHECK_THROWS_AS(picture::encode_png(0, 0, {}), Fault);
    CHECK_THROWS_AS(picture::encode_png(-1, 2, gradient(2, 2)), Fault);
}
