#include "webp_animation.hpp"

#include <webp/demux.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <vector>

#include "file_size_limit.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using film::WebpAnimation;

namespace {

std::vector<std::uint8_t> shade(std::uint8_t value) { return std::vector<std::uint8_t>(3 * 40 * 30, value); }

}  // namespace

TEST_CASE("an animation holds every picture at its time", "[unit]") {
    const test::Scratch scratch;
    const auto file = scratch.path("a.webp");
    WebpAnimation video(file, {40, 30, 25});
    for (std::uint8_t value : {20, 120, 220}) video.add(shade(value));
    CHECK_FALSE(std::filesystem::exists(file));
    video.close();
    CHECK(scratch.count() == 1);

    std::ifstream in(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    const WebPData data{bytes.data(), bytes.size()};
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
    REQUIRE(decoder != nullptr);
    std::vector<int> ends;
    std::vector<int> shades;
    while (WebPAnimDecoderHasMoreFrames(decoder) != 0) {
        std::uint8_t* rgba = nullptr;
        int end = 0;
        REQUIRE(WebPAnimDecoderGetNext(decoder, &rgba, &end) != 0);
        ends.push_back(end);
        shades.push_back(rgba[0]);
    }
    WebPAnimDecoderDelete(decoder);
    CHECK(ends == std::vector<int>{40, 80, 120});
    REQUIRE(shades.size() == 3);
    CHECK(std::abs(shades[1] - 120) <= 3);
}

TEST_CASE("no pictures, no file; too large or a full disk, a limit in words", "[extreme]") {
    const test::Scratch scratch;
    WebpAnimation empty(scratch.path("a.webp"), {40, 30, 25});
    empty.close();
    CHECK_THROWS_WITH(WebpAnimation(scratch.path("a.webp"), {20000, 30, 25}),
                      "An animated WebP is at most 16383 pixels a side; ask for a smaller --size.");
    WebpAnimation video(scratch.path("a.webp"), {40, 30, 25});
    video.add(shade(3));
    const test::FileSizeLimit full(10);
    CHECK_THROWS_AS(video.close(), Fault);
    CHECK(scratch.count() == 0);
}
