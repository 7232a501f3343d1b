#include "part_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "signal_blocked.hpp"

namespace orbweaver::film {
namespace {

class Descriptor {
public:
    explicit Descriptor(int value) noexcept : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    int value() const noexcept { return value_; }
    int close() noexcept {
        const int result = ::close(value_);
        value_ = -1;
        return result;
    }

private:
    int value_;
};

/// 0, or the errno of the call that failed.
int write_bytes(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) noexcept {
    const SignalBlocked blocked(SIGXFSZ);
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.value() < 0) return errno;
    while (!bytes.empty()) {
        const auto n = ::write(file.value(), bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) return errno;
        if (n > 0) bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return file.close() == 0 ? 0 : errno;  // some file systems say only now that the disk is full
}

}  // namespace

Fault io_fault(const std::string& action, const std::filesystem::path& path, int error) {
    const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    return {full ? FaultKind::limit : FaultKind::internal,
            action + " " + path.string() + " failed: " + std::generic_category().message(error) +
                (full ? "; make room or write elsewhere." : "; check the path and its permissions.")};
}

std::filesystem::path part_path(const std::filesystem::path& path) {
    std::string name = ".";
    name += path.stem().string();
    name += ".part";
    name += path.extension().string();
    return path.parent_path() / name;
}

void rename_part(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::rename(part_path(path), path, error);
    if (error) throw io_fault("Naming the finished file", path, error.value());
}

void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    const auto part = part_path(path);
    std::error_code ignored;
    const int error = write_bytes(part, bytes);
    if (error != 0) {
        std::filesystem::remove(part, ignored);
        throw io_fault("Writing", path, error);
    }
    try {
        rename_part(path);
    } catch (...) {
        std::filesystem::remove(part, ignored);
        throw;
    }
}

void make_writable_directory(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) throw io_fault("Making the directory", directory, error.value());
    if (!std::filesystem::is_directory(directory)) throw io_fault("Making the directory", directory, ENOTDIR);
    const auto trial = directory / ".trial.part";
    const int failed = write_bytes(trial, {});
    std::filesystem::remove(trial, error);
    if (failed != 0) throw io_fault("Writing into", directory, failed);
}

}  // namespace orbweaver::film
