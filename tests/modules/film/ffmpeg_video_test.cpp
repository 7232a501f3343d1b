#include "ffmpeg_video.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "file_size_limit.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using film::FfmpegVideo;

namespace {

/// A stand-in for ffmpeg: a shell script that knows its last argument, the file to write.
std::string stand_in(const test::Scratch& scratch, const std::string& commands) {
    const auto program =
        scratch.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\nfile=\"${last#file:}\"\n" + commands);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
}

std::vector<std::uint8_t> noise(std::size_t n) {
    std::vector<std::uint8_t> rgb(n);
    for (std::size_t i = 0; i < n; ++i) rgb[i] = static_cast<std::uint8_t>(i * i * 2654435761U >> 20);
    return rgb;
}

FaultRecord caught(const std::string& program, const std::string& file, int pictures) {
    try {
        FfmpegVideo video(program, file, {64, 48, 30});
        for (int i = 0; i < pictures; ++i) video.add(noise(3 * 64 * 48));
        video.close();
    } catch (const Fault& e) {
        return {e.kind(), e.what()};
    }
    return {FaultKind::internal, "made"};
}

std::string real_ffmpeg() {
    const char* path = std::getenv("PATH");
    return film::plan_video("a.mp4", path != nullptr ? path : "").ffmpeg.string();
}

}  // namespace

TEST_CASE("every byte reaches the process, and the file gets its name when it is whole", "[unit]") {
    const test::Scratch scratch;
    const auto program = stand_in(scratch, "cat > \"$file\"\n");
    const auto file = scratch.path("a.mp4");
    {
        FfmpegVideo video(program, file, {64, 48, 30});
        for (int i = 0; i < 100; ++i) video.add(noise(3 * 64 * 48));
        CHECK_FALSE(std::filesystem::exists(file));
        video.close();
    }
    CHECK(std::filesystem::file_size(file) == 100 * 3 * 64 * 48);
    CHECK(scratch.count() == 2);
}

TEST_CASE("a process that dies is a fault with its last words, and no file is left", "[extreme]") {
    const test::Scratch scratch;
    struct Case {
        std::string commands;
        FaultKind kind;
        std::string words;
    };
    const Case cases[] = {
        {"echo part > \"$file\"; echo 'no encoder' >&2; exit 3", FaultKind::internal,
         "ended with exit code 3 and said: no encoder; or name a .webp file, which needs no ffmpeg."},
        {"echo part > \"$file\"; cat > /dev/null; echo 'No space left on device' >&2; exit 1", FaultKind::limit,
         "ended with exit code 1 and said: No space left on device; make room or write elsewhere."},
        {"kill -9 $$", FaultKind::internal, "was ended by signal 9 and said: nothing"},
    };
    for (const Case& each : cases) {
        const auto fault = caught(stand_in(scratch, each.commands), scratch.path("a.mp4"), 50);
        INFO(fault.sentence);
        CHECK(fault.kind == each.kind);
        CHECK(fault.sentence.find("Making the video " + scratch.path("a.mp4") + " failed: ffmpeg ") == 0);
        CHECK(fault.sentence.find(each.words) != std::string::npos);
        CHECK(scratch.count() == 1);
    }
}

TEST_CASE("a program that cannot start is a fault", "[extreme]") {
    const test::Scratch scratch;
    const auto fault = caught(scratch.path("absent"), scratch.path("a.mp4"), 1);
    CHECK(fault.sentence.find("Starting " + scratch.path("absent")) == 0);
}

TEST_CASE("a video that is given up leaves no file and no process", "[extreme]") {
    const test::Scratch scratch;
    {
        FfmpegVideo video(stand_in(scratch, "cat > \"$file\"\n"), scratch.path("a.mp4"), {64, 48, 30});
        video.add(noise(3 * 64 * 48));
    }
    CHECK(scratch.count() == 1);
}

TEST_CASE("a finished video that cannot get its name leaves nothing", "[extreme]") {
    const test::Scratch scratch;
    const auto program = stand_in(scratch, "cat > \"$file\"\n");
    FfmpegVideo video(program, scratch.path("a.mp4"), {64, 48, 30});
    video.add(noise(3 * 64 * 48));
    std::filesystem::create_directory(scratch.path("a.mp4"));
    CHECK_THROWS_AS(video.close(), Fault);
    CHECK(scratch.count() == 2);
}

TEST_CASE("the process has its signals, whatever we block and ignore", "[unit]") {
    const test::Scratch scratch;
    const auto program =
        stand_in(scratch, "cat > /dev/null; grep -E 'Sig(Blk|Ign)' /proc/self/status > \"$file\"\n");
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    const auto handler = ::signal(SIGPIPE, SIG_IGN);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);
    FfmpegVideo video(program, scratch.path("a.mp4"), {64, 48, 30});
    video.close();
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::signal(SIGPIPE, handler);
    std::ifstream file(scratch.path("a.mp4"));
    std::string name;
    for (std::string mask; file >> name >> mask;) {
        CAPTURE(name, mask);
        const auto bits = std::stoull(mask, nullptr, 16);
        CHECK((bits & (1ULL << (SIGPIPE - 1))) == 0);
        if (name == "SigBlk:") CHECK((bits & (1ULL << (SIGTERM - 1))) == 0);
    }
    CHECK(name == "SigIgn:");
}

TEST_CASE("the real ffmpeg makes a video of odd size, and says when the disk is full", "[scene]") {
    const auto ffmpeg = real_ffmpeg();
    if (ffmpeg.empty()) {
        WARN("no ffmpeg on PATH: the real one is not tried");
        return;
    }
    const test::Scratch scratch;
    {
        FfmpegVideo video(ffmpeg, scratch.path("a.mp4"), {63, 47, 30});
        for (int i = 0; i < 10; ++i) video.add(noise(3 * 63 * 47));
        video.close();
    }
    CHECK(std::filesystem::file_size(scratch.path("a.mp4")) > 1000);
    const test::FileSizeLimit full(2000);
    const auto fault = caught(ffmpeg, scratch.path("b.mp4"), 60);
    CHECK(fault.kind == FaultKind::limit);
    CHECK(scratch.count() == 1);
}
