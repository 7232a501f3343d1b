#include "frame_files.hpp"

#include <string>

#include "output/atomic_file.hpp"
#include "picture/png.hpp"

namespace orbweaver::film {

FrameFiles::FrameFiles(std::filesystem::path directory) : directory_(std::move(directory)) {
    const AtomicFile trial(path(0));
}

std::string FrameFiles::path(std::uint64_t index) const {
    auto number = std::to_string(index);
    if (number.size() < 6) number.insert(0, 6 - number.size(), '0');
    return directory_ / ("frame_" + number + ".png");
}

void FrameFiles::add(int width, int height, std::span<const std::uint8_t> rgb) {
    const auto png = picture::encode_png(width, height, rgb);
    AtomicFile file(path(count_));
    file.write(png.data(), png.size());
    file.commit();
    ++count_;
}

}  // namespace orbweaver::film
