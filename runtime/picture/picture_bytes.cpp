#include "picture/picture_bytes.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace orbweaver::picture {
namespace {

constexpr const char* kExpected = "a PNG, JPEG or Radiance HDR picture";

[[noreturn]] void refuse(const std::string& path, const std::string& what, const std::string& remedy,
                         FaultKind kind = FaultKind::invalid) {
    Diagnostic fault;
    fault.where.file = path;
    fault.what = what;
    fault.expected = kExpected;
    fault.remedy = remedy;
    throw Unreadable(fault, kind);
}

bool begins_with(const std::vector<std::uint8_t>& bytes, std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

Format recognize(const PictureBytes& file) {
    if (begins_with(file.bytes, "\x89PNG\r\n\x1a\n")) return Format::png;
    if (begins_with(file.bytes, "\xff\xd8\xff")) return Format::jpeg;
    if (begins_with(file.bytes, "#?RADIANCE\n") || begins_with(file.bytes, "#?RGBE\n")) return Format::hdr;
    refuse(file.path, "the file's first bytes are those of no picture format read here",
           "convert it to PNG, or name another file");
}

std::size_t size_of_regular_file(const std::string& path, const Limits& limits) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) refuse(path, "there is no such file", "correct the path");
    if (!std::filesystem::is_regular_file(status)) refuse(path, "it is not a regular file", "correct the path");
    const auto size = std::filesystem::file_size(path, error);
    if (error) refuse(path, "its size cannot be read: " + error.message(), "");
    if (size == 0) refuse(path, "the file is empty", "fetch or make it again");
    if (size > limits.file_bytes)
        refuse(path,
               "the file has " + std::to_string(size) + " bytes, more than the limit of " +
                   std::to_string(limits.file_bytes),
               "make it smaller", FaultKind::limit);
    return static_cast<std::size_t>(size);
}

}  // namespace

const char* name(Format format) noexcept {
    switch (format) {
        case Format::png:
            return "PNG";
        case Format::jpeg:
            return "JPEG";
        case Format::hdr:
            return "Radiance HDR";
    }
    return "";
}

PictureBytes read_picture_bytes(const std::string& path, const Limits& limits) {
    PictureBytes file{path, Format::png, {}};
    file.bytes.resize(size_of_regular_file(path, limits));
    std::ifstream in(path, std::ios::binary);
    if (!in) refuse(path, "the file cannot be opened", "check its permissions");
    if (!in.read(reinterpret_cast<char*>(file.bytes.data()), static_cast<std::streamsize>(file.bytes.size())))
        refuse(path, "the file cannot be read to its end", "check the disk it lies on");
    file.format = recognize(file);
    return file;
}

}  // namespace orbweaver::picture
