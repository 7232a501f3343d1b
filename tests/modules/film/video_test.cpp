#include "video.hpp"

#include <catch2/catch.hpp>

#include "scratch.hpp"

using namespace orbweaver;
using film::plan_video;

TEST_CASE("ffmpeg is used when it is found and the name does not ask for WebP", "[unit]") {
    const test::Scratch scratch;
    const auto program = scratch.write("ffmpeg", "#!/bin/sh\n");
    const auto path = "/nonexistent::" + scratch.path();

    CHECK(plan_video("a.mp4", path).ffmpeg.empty());  // not executable
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    CHECK(plan_video("a.mp4", path).ffmpeg == program);
    CHECK(plan_video("a.mp4", path).file == "a.mp4");
    CHECK(plan_video("a.webp", path).ffmpeg.empty());

    CHECK(plan_video("out/a.mp4", "").file == "out/a.webp");
    CHECK(plan_video("a.MOV", path).ffmpeg == program);
}

TEST_CASE("an extension that says nothing of how to make a video is refused", "[extreme]") {
    for (const char* name : {"a.webm", "a.gif", "a", "out.mp4/a", ".mp4"}) {
        CAPTURE(name);
        CHECK_THROWS_WITH(plan_video(name, ""),
                          std::string("The video ") + name +
                              " has no extension that says how to make it; expected .mp4, .m4v, .mov, .mkv or "
                              ".webp.");
    }
}
