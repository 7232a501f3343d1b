#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace orbweaver::film {

struct VideoFormat {
    int width = 0;
    int height = 0;
    double pictures_per_second = 0;
};

/// A moving picture that grows under its part name and gets its final name when it is whole.
class Video {
public:
    virtual ~Video() = default;
    Video() = default;
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Throws Fault, after which only destruction makes sense.
    virtual void add(std::span<const std::uint8_t> rgb) = 0;
    /// Finishes and names the file. Throws Fault; then there is no file.
    virtual void close() = 0;
};

/// How a video will be made: .mp4, .m4v, .mov and .mkv through ffmpeg if that is found, else, and for .webp, as
/// an animated WebP under the name with that extension.
struct VideoPlan {
    std::filesystem::path file;
    std::filesystem::path ffmpeg;  ///< empty: WebP
};
/// Throws Fault(invalid) for other extensions. `search_path` as the environment's PATH has it.
VideoPlan plan_video(const std::filesystem::path& asked, const std::string& search_path);

/// Throws Fault.
std::unique_ptr<Video> open_video(const VideoPlan& plan, const VideoFormat& format);

}  // namespace orbweaver::film
