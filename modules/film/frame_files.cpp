#include "frame_files.hpp"

#include <string>

#include "part_file.hpp"
#include "picture/png.hpp"

namespace orbweaver::film {

FrameFiles::FrameFiles(std::filesystem::path directory) : directory_(std::move(directory)) {
    make_writable_directory(directory_);
}

void FrameFiles::add(int width, int height, std::span<const std::uint8_t> rgb) {
    auto number = std::to_string(count_);
    if (number.size() < 6) number.insert(0, 6 - number.size(), '0');
    write_whole(directory_ / ("frame_" + number + ".png"), picture::encode_png(width, height, rgb));
    ++count_;
}

}  // namespace orbweaver::film
