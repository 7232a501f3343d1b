#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "fake_host.hpp"
#include "file_size_limit.hpp"
#include "orbweaver/contracts/picture_source.hpp"
#include "scratch.hpp"

using namespace orbweaver;

namespace {

struct Gray final : PictureSource {
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(3 * 31 * 17, 99);
    int width() const noexcept override { return 31; }
    int height() const noexcept override { return 17; }
    std::span<const std::uint8_t> rgb() noexcept override { return pixels; }
};

/// Another PATH for as long as it lives.
class SearchPath {
public:
    explicit SearchPath(const char* path) {
        if (const char* before = std::getenv("PATH")) before_ = before;
        setenv("PATH", path, 1);
    }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;
    ~SearchPath() {
        if (before_) setenv("PATH", before_->c_str(), 1);
    }

private:
    std::optional<std::string> before_;
};

struct Set {
    Set() {
        host.scene_.step = 0.02;
        host.offer<PictureSource>(gray);
    }
    test::Scratch scratch;
    Gray gray;
    test::FakeHost host;
    test::LoadedModule film{"film"};
};

}  // namespace

TEST_CASE("frames and video of one run, without ffmpeg as animated WebP and said so", "[scene]") {
    Set set;
    const SearchPath empty("");
    set.host.request_.frames_directory = set.scratch.path("deep/frames");
    set.host.request_.video_file = set.scratch.path("deep/film.mp4");
    REQUIRE(set.film.attach(set.host));
    REQUIRE(set.host.logged.size() == 1);
    CHECK(set.host.logged[0] == "There is no ffmpeg on PATH, so the video becomes an animated WebP: " +
                                    set.scratch.path("deep/film.webp") + ".");
    for (std::uint64_t i = 0; i < 3; ++i) REQUIRE(set.film.run(i));
    REQUIRE(set.film.finish());
    CHECK(std::filesystem::file_size(set.scratch.path("deep/film.webp")) > 20);
    CHECK(std::filesystem::exists(set.scratch.path("deep/frames/frame_000002.png")));
    CHECK(set.film.report().measures[1].second == MeasureValue{set.scratch.path("deep/film.webp")});
    CHECK(set.film.report().measures[2].second == MeasureValue{set.scratch.path("deep/frames")});
}

TEST_CASE("what cannot be written fails before the run starts", "[extreme]") {
    struct Case {
        std::string frames;
        std::string video;
        std::string words;
    };
    const test::Scratch other;
    const auto file = other.write("file", "");
    std::filesystem::create_directory(other.path("folder.webp"));
    const Case cases[] = {
        {file, "", file + "/frame_000000.png: cannot be written: Not a directory"},
        {file + "/frames", "", file + "/frames/frame_000000.png: cannot be written: Not a directory"},
        {"", file + "/a.webp", file + "/a.webp: cannot be written: Not a directory"},
        {"", other.path("folder.webp"), other.path("folder.webp") + ": cannot be written: it is a folder"},
        {"", other.path("a.webm"), "The video " + other.path("a.webm") + " has no extension that says how"},
    };
    const SearchPath path("/usr/bin:/bin");
    for (const Case& each : cases) {
        Set set;
        set.host.request_.frames_directory = each.frames;
        set.host.request_.video_file = each.video;
        REQUIRE_FALSE(set.film.attach(set.host));
        INFO(set.film.fault.sentence);
        CHECK(set.film.fault.sentence.find(each.words) == 0);
    }
}

TEST_CASE("a disk that fills during the run is a limit, and no half of a file stays", "[extreme]") {
    Set set;
    set.host.request_.frames_directory = set.scratch.path("frames");
    REQUIRE(set.film.attach(set.host));
    REQUIRE(set.film.run(0));
    {
        const test::FileSizeLimit full(20);
        REQUIRE_FALSE(set.film.run(1));
    }
    CHECK(set.film.fault.kind == FaultKind::limit);
    REQUIRE(set.film.finish());
    const std::filesystem::directory_iterator frames(set.scratch.path("frames"));
    CHECK(std::distance(begin(frames), end(frames)) == 1);
}

TEST_CASE("of a run without a picture no file is claimed", "[scene]") {
    Set set;
    set.host.request_.frames_directory = set.scratch.path("frames");
    set.host.request_.video_file = set.scratch.path("film.webp");
    REQUIRE(set.film.attach(set.host));
    REQUIRE(set.film.finish());
    CHECK(set.film.report().measures.size() == 1);
    CHECK_FALSE(std::filesystem::exists(set.scratch.path("film.webp")));
}
