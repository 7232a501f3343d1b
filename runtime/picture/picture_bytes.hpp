#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "picture/decode.hpp"

namespace orbweaver::picture {

enum class Format : std::uint8_t { png, jpeg, hdr };

/// A picture file as it lies on the disk.
struct PictureBytes {
    std::string path;
    Format format = Format::png;
    std::vector<std::uint8_t> bytes;
};

/// Reads the file and recognizes its format by its first bytes. Throws Unreadable: no such file, not a
/// regular file, empty, too large, of another format.
PictureBytes read_picture_bytes(const std::string& path, const Limits& limits);

const char* name(Format format) noexcept;

}  // namespace orbweaver::picture
