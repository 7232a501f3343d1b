#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include "frame_files.hpp"
#include "manifest_text.hpp"
#include "orbweaver/contracts/picture_source.hpp"
#include "orbweaver/entry.hpp"
#include "output/atomic_file.hpp"
#include "video.hpp"

namespace orbweaver::film {
namespace {

/// Takes every picture of the run and writes it down as the request asks.
class Film final : public Module {
public:
    void attach(Host& host) override;
    void run(Phase phase, const Frame& frame) override;
    void finish() override;
    void report(ModuleReport& report) override;

private:
    void plan(Host& host, const std::filesystem::path& asked);
    void add_to_video(std::span<const std::uint8_t> rgb);

    PictureSource* source_ = nullptr;
    std::optional<FrameFiles> frames_;
    std::optional<VideoPlan> plan_;
    std::unique_ptr<Video> video_;
    bool closed_ = false;  // the video is whole, under its name
    VideoFormat format_;
    std::int64_t pictures_ = 0;
};

void Film::attach(Host& host) {
    source_ = host.find<PictureSource>();
    const Request& request = host.request();
    format_.pictures_per_second =
        request.frames_per_second > 0 ? request.frames_per_second : 1 / host.scene().step;
    if (!request.frames_directory.empty()) frames_.emplace(request.frames_directory);
    if (!request.video_file.empty()) plan(host, request.video_file);
}

void Film::plan(Host& host, const std::filesystem::path& asked) {
    const char* search_path = std::getenv("PATH");
    plan_ = plan_video(asked, search_path != nullptr ? search_path : "");
    const AtomicFile trial(plan_->file.string());
    if (plan_->file != asked)
        host.log(LogLevel::warning, "There is no ffmpeg on PATH, so the video becomes an animated WebP: " +
                                        plan_->file.string() + ".");
}

void Film::run(Phase, const Frame&) {
    const auto rgb = source_->rgb();
    if (frames_) frames_->add(source_->width(), source_->height(), rgb);
    if (plan_) add_to_video(rgb);
    ++pictures_;
}

void Film::add_to_video(std::span<const std::uint8_t> rgb) {
    if (!video_ && pictures_ == 0) {
        format_.width = source_->width();
        format_.height = source_->height();
        video_ = open_video(*plan_, format_);
    }
    if (!video_) return;
    try {
        video_->add(rgb);
    } catch (...) {
        video_.reset();  // and with it what was half-written
        throw;
    }
}

void Film::finish() {
    const auto video = std::move(video_);
    if (!video) return;
    video->close();
    closed_ = true;
}

void Film::report(ModuleReport& report) {
    report.measure("pictures", pictures_);
    if (closed_) report.measure("video", plan_->file.string());
    if (frames_ && frames_->count() > 0) report.measure("frames", frames_->directory().string());
}

}  // namespace
}  // namespace orbweaver::film

ORBWEAVER_MODULE(orbweaver::film::Film)
