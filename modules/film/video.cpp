#include "video.hpp"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

#include "ffmpeg_video.hpp"
#include "orbweaver/fault.hpp"
#include "webp_animation.hpp"

namespace orbweaver::film {
namespace {

constexpr std::string_view kExtensions[] = {".mp4", ".m4v", ".mov", ".mkv", ".webp"};

std::filesystem::path find_program(const std::string& name, const std::string& search_path) {
    std::istringstream directories(search_path);
    for (std::string directory; std::getline(directories, directory, ':');) {
        auto candidate = std::filesystem::path(directory) / name;
        std::error_code ignored;
        const bool file = !directory.empty() && std::filesystem::is_regular_file(candidate, ignored);
        if (file && ::access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return {};
}

}  // namespace

VideoPlan plan_video(const std::filesystem::path& asked, const std::string& search_path) {
    auto extension = asked.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (std::find(std::begin(kExtensions), std::end(kExtensions), extension) == std::end(kExtensions))
        throw Fault(FaultKind::invalid, "The video " + asked.string() +
                                            " has no extension that says how to make it; expected .mp4, .m4v, "
                                            ".mov, .mkv or .webp.");
    if (extension == ".webp") return {asked, {}};
    const auto ffmpeg = find_program("ffmpeg", search_path);
    if (!ffmpeg.empty()) return {asked, ffmpeg};
    return {std::filesystem::path(asked).replace_extension(".webp"), {}};
}

std::unique_ptr<Video> open_video(const VideoPlan& plan, const VideoFormat& format) {
    if (plan.ffmpeg.empty()) return std::make_unique<WebpAnimation>(plan.file, format);
    return std::make_unique<FfmpegVideo>(plan.ffmpeg, plan.file, format);
}

}  // namespace orbweaver::film
