#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "output/atomic_file.hpp"
#include "video.hpp"

namespace orbweaver::film {

/// H.264 made by an `ffmpeg` process that reads raw pictures from us through a socket: writing to a dead
/// one is an error (MSG_NOSIGNAL), where a pipe would raise SIGPIPE in the whole process.
class FfmpegVideo final : public Video {
public:
    /// Starts the process. Throws Fault.
    FfmpegVideo(const std::filesystem::path& ffmpeg, const std::filesystem::path& file,
                const VideoFormat& format);
    /// Ends the process, if close() did not finish it.
    ~FfmpegVideo() override;
    void add(std::span<const std::uint8_t> rgb) override;
    void close() override;

private:
    void start(const std::filesystem::path& ffmpeg, int input, const VideoFormat& format);
    int wait() noexcept;
    void hang_up() noexcept;
    [[noreturn]] void fail_by_status(int status);
    std::string last_words() const;

    AtomicFile file_;
    pid_t process_ = -1;
    int socket_ = -1;
    int words_ = -1;  // what the process writes on its standard error
};

}  // namespace orbweaver::film
