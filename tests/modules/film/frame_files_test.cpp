#include "frame_files.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "picture/decode.hpp"
#include "scratch.hpp"

using namespace orbweaver;

TEST_CASE("frames are numbered from zero and hold the pixels", "[unit]") {
    const test::Scratch scratch;
    const auto directory = scratch.path("frames");
    std::filesystem::create_directories(directory);
    scratch.write("frames/frame_000001.png", "of an older run");
    scratch.write("frames/frame_000007.png", "of an older run");

    film::FrameFiles frames(directory);
    for (std::uint8_t shade : {10, 20}) frames.add(5, 3, std::vector<std::uint8_t>(45, shade));
    CHECK(frames.count() == 2);
    CHECK(picture::decode(directory + "/frame_000000.png").rgb == std::vector<std::uint8_t>(45, 10));
    CHECK(picture::decode(directory + "/frame_000001.png").rgb == std::vector<std::uint8_t>(45, 20));
    CHECK(std::filesystem::file_size(directory + "/frame_000007.png") == 15);
}
