#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace orbweaver::film {

/// frame_000000.png, frame_000001.png, ... in one directory. Frames that an older run left there under the
/// same names are overwritten, others stay.
class FrameFiles {
public:
    /// Makes the directory and tries the first frame's file. Throws Fault.
    explicit FrameFiles(std::filesystem::path directory);
    /// Throws Fault; a frame is there whole or not at all.
    void add(int width, int height, std::span<const std::uint8_t> rgb);
    std::uint64_t count() const noexcept { return count_; }
    const std::filesystem::path& directory() const noexcept { return directory_; }

private:
    std::string path(std::uint64_t index) const;

    std::filesystem::path directory_;
    std::uint64_t count_ = 0;
};

}  // namespace orbweaver::film
