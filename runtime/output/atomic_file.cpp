#include "output/atomic_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "orbweaver/fault.hpp"

namespace orbweaver {

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), target_(path_) {
    std::error_code error;
    const auto status = std::filesystem::status(path_, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw Fault(FaultKind::internal,
                    fmt::format("{}: cannot be written: it is {}; name a file", path_,
                                std::filesystem::is_directory(status) ? "a folder" : "not a regular file"));
    // Behind a link lies the file that is meant: the link itself stays.
    if (std::filesystem::exists(status)) target_ = std::filesystem::canonical(path_, error).string();
    partial_ = target_ + ".partial";
    file_ = std::fopen(partial_.c_str(), "wb");
    if (file_ == nullptr) fail("be written");
}

AtomicFile::~AtomicFile() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::remove(partial_.c_str());
}

void AtomicFile::fail(const char* doing) {
    if (error_ == 0) error_ = errno != 0 ? errno : EIO;
    const bool full = error_ == ENOSPC || error_ == EDQUOT || error_ == EFBIG;
    throw Fault(full ? FaultKind::limit : FaultKind::internal,
                fmt::format("{}: cannot {}: {}; {}", path_, doing, std::strerror(error_),
                            full ? "make room and run again, nothing half-written was left"
                                 : "check that the folder exists and may be written"));
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

void make_directory(const std::string& path, const char* purpose) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error || !std::filesystem::is_directory(path))
        throw Fault(
            FaultKind::internal,
            fmt::format(
                "{}: the folder for {} cannot be made: {}; choose another, or change its parent's permissions",
                path, purpose, error ? error.message() : "something else has that name"));
}

}  // namespace orbweaver
