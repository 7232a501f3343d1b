#include "output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;
constexpr int kMostPartials = 10000;

/// What a path names in the end, whether that exists or not.
fs::path behind_links(fs::path path) {
    std::error_code ignored;
    for (int i = 0; i < kMostLinks && fs::is_symlink(path, ignored); ++i)
        path = path.parent_path() / fs::read_symlink(path, ignored);
    return path;
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), target_(behind_links(path_).string()) {
    std::error_code ignored;
    const auto status = fs::status(target_, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Fault(FaultKind::internal, path_ + ": cannot be written: it is " +
                                             (fs::is_directory(status) ? "a folder" : "not a regular file") +
                                             "; name a file");
    if (const auto parent = fs::path(target_).parent_path(); !parent.empty())
        fs::create_directories(parent, ignored);  // if it cannot be made, opening will say why
    open_partial();
}

AtomicFile::~AtomicFile() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::remove(partial_.c_str());
}

// The extension stays at the end: encoders tell the format by it. O_EXCL refuses files and links of others.
void AtomicFile::open_partial() {
    const fs::path target(target_);
    int descriptor = -1;
    errno = EEXIST;
    for (int i = 0; i < kMostPartials && descriptor < 0 && errno == EEXIST; ++i) {
        const std::string name =
            "." + target.stem().string() + ".part" + std::to_string(i) + target.extension().string();
        partial_ = (target.parent_path() / name).string();
        descriptor = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    if (descriptor < 0) fail("be written");
    file_ = ::fdopen(descriptor, "wb");
    if (file_ != nullptr) return;
    ::close(descriptor);
    std::remove(partial_.c_str());
    errno = ENOMEM;
    fail("be written");
}

void AtomicFile::fail(const char* doing) {
    if (error_ == 0) error_ = errno != 0 ? errno : EIO;
    const bool full = error_ == ENOSPC || error_ == EDQUOT || error_ == EFBIG;
    throw Fault(full ? FaultKind::limit : FaultKind::internal,
                path_ + ": cannot " + doing + ": " + std::strerror(error_) +
                    (full ? "; make room and run again, nothing half-written was left"
                          : "; check that the folder exists and may be written"));
}

void AtomicFile::write(const void* data, std::size_t size) {
    if (error_ != 0 || (size > 0 && std::fwrite(data, 1, size, file_) != size)) fail("be written");
}

void AtomicFile::rewrite_front(std::string_view text) {
    if (error_ != 0 || std::fseek(file_, 0, SEEK_SET) != 0) fail("be written");
    write(text);
}

void AtomicFile::commit() {
    if (error_ != 0 || std::fflush(file_) != 0) fail("be written");
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0 || std::rename(partial_.c_str(), target_.c_str()) != 0) {
        const int error = errno;
        std::remove(partial_.c_str());
        errno = error;
        fail("be completed");
    }
}

}  // namespace orbweaver
