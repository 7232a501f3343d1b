#pragma once

#include <filesystem>
#include <memory>

#include "video.hpp"

struct WebPAnimEncoder;

namespace orbweaver::film {

/// An animated WebP, lossy. Keeps the compressed pictures in memory until it is closed.
class WebpAnimation final : public Video {
public:
    WebpAnimation(std::filesystem::path file, const VideoFormat& format);
    ~WebpAnimation() override;
    void add(std::span<const std::uint8_t> rgb) override;
    void close() override;

private:
    int time_ms(std::uint64_t picture) const;
    [[noreturn]] void fail(const char* why) const;

    struct EncoderDelete {
        void operator()(WebPAnimEncoder* encoder) const noexcept;
    };
    std::filesystem::path file_;
    VideoFormat format_;
    std::unique_ptr<WebPAnimEncoder, EncoderDelete> encoder_;
    std::uint64_t count_ = 0;
};

}  // namespace orbweaver::film
