#include "cli/picture_size.hpp"

#include <charconv>

namespace orbweaver {

namespace {

constexpr int kMostPixels = 16384;

std::optional<int> parse_side(std::string_view text) {
    int pixels = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, pixels);
    if (error != std::errc() || rest != end || pixels < 1 || pixels > kMostPixels) return {};
    return pixels;
}

}  // namespace

std::optional<PictureSize> parse_picture_size(std::string_view text) {
    const auto cross = text.find('x');
    if (cross == std::string_view::npos) return {};
    const auto width = parse_side(text.substr(0, cross));
    const auto height = parse_side(text.substr(cross + 1));
    if (!width || !height) return {};
    return PictureSize{*width, *height};
}

}  // namespace orbweaver
