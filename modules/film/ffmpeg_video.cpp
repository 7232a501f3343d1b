#include "ffmpeg_video.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver::film {
namespace {

/// Raw sRGB in; out, what players everywhere understand: 4:2:0 (hence even sizes) with BT.709 colors, said so.
std::vector<std::string> arguments(const VideoFormat& format, const std::string& part) {
    const auto size = std::to_string(format.width) + "x" + std::to_string(format.height);
    return {"ffmpeg",
            "-nostdin",
            "-hide_banner",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb24",
            "-video_size",
            size,
            "-framerate",
            std::to_string(format.pictures_per_second),
            "-i",
            "pipe:0",
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
            "-c:v",
            "libx264",
            "-preset",
            "veryfast",
            "-crf",
            "18",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-color_range",
            "tv",
            "-movflags",
            "+faststart",
            "file:" + part};
}

struct SpawnSettings {
    SpawnSettings() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
};

Fault start_fault(const std::string& action, const std::string& video, int error) {
    return {FaultKind::internal, action + " for " + video +
                                     " failed: " + std::generic_category().message(error) +
                                     "; name a .webp file, which needs no ffmpeg."};
}

}  // namespace

FfmpegVideo::FfmpegVideo(const std::filesystem::path& ffmpeg, const std::filesystem::path& file,
                         const VideoFormat& format)
    : file_(file.string()) {
    int ends[2];
    words_ = memfd_create("ffmpeg", MFD_CLOEXEC);
    if (words_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        const int error = errno;
        hang_up();
        throw start_fault("Preparing a connection to ffmpeg", file_.path(), error);
    }
    socket_ = ends[0];
    start(ffmpeg, ends[1], format);
}

void FfmpegVideo::start(const std::filesystem::path& ffmpeg, int input, const VideoFormat& format) {
    auto words = arguments(format, file_.partial());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    SpawnSettings settings;
    posix_spawn_file_actions_adddup2(&settings.files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&settings.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&settings.files, words_, STDERR_FILENO);
    // A group of its own: Ctrl+C ends our run, which then closes the video in order. Signals that we block or
    // ignore are ffmpeg's again.
    sigset_t none;
    sigset_t of_writes;
    sigemptyset(&none);
    sigemptyset(&of_writes);
    sigaddset(&of_writes, SIGPIPE);
    sigaddset(&of_writes, SIGXFSZ);
    posix_spawnattr_setsigmask(&settings.attributes, &none);
    posix_spawnattr_setsigdefault(&settings.attributes, &of_writes);
    posix_spawnattr_setflags(&settings.attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int error =
        posix_spawn(&process_, ffmpeg.c_str(), &settings.files, &settings.attributes, argv.data(), environ);
    ::close(input);
    if (error == 0) return;
    process_ = -1;
    hang_up();
    throw start_fault("Starting " + ffmpeg.string(), file_.path(), error);
}

FfmpegVideo::~FfmpegVideo() {
    if (process_ > 0) kill(process_, SIGKILL);
    wait();
    hang_up();
}

void FfmpegVideo::add(std::span<const std::uint8_t> rgb) {
    while (!rgb.empty()) {
        const auto n = ::send(socket_, rgb.data(), rgb.size(), MSG_NOSIGNAL);
        if (n > 0) rgb = rgb.subspan(static_cast<std::size_t>(n));
        if (n < 0 && errno != EINTR) fail_by_status(wait());
    }
}

void FfmpegVideo::close() {
    ::close(socket_);
    socket_ = -1;
    const int status = wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail_by_status(status);
    file_.commit();
}

int FfmpegVideo::wait() noexcept {
    int status = 0;
    if (process_ <= 0) return status;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
}

void FfmpegVideo::hang_up() noexcept {
    for (int* each : {&socket_, &words_}) {
        if (*each >= 0) ::close(*each);
        *each = -1;
    }
}

std::string FfmpegVideo::last_words() const {
    std::string words(1000, '\0');
    const auto n = pread(words_, words.data(), words.size(), 0);
    words.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    for (char& c : words)
        if (c == '\n') c = ' ';
    while (!words.empty() && words.back() == ' ') words.pop_back();
    return words.empty() ? "nothing" : words;
}

void FfmpegVideo::fail_by_status(int status) {
    const auto words = last_words();
    const bool size_limit = WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ;
    const bool full = size_limit || words.find("No space left") != std::string::npos ||
                      words.find("File too large") != std::string::npos ||
                      words.find("quota") != std::string::npos;
    const auto end = WIFSIGNALED(status) ? "was ended by signal " + std::to_string(WTERMSIG(status))
                                         : "ended with exit code " + std::to_string(WEXITSTATUS(status));
    throw Fault(
        full ? FaultKind::limit : FaultKind::internal,
        "Making the video " + file_.path() + " failed: ffmpeg " + end + " and said: " + words +
            (full ? "; make room or write elsewhere." : "; or name a .webp file, which needs no ffmpeg."));
}

}  // namespace orbweaver::film
