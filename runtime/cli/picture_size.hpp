#pragma once

#include <optional>
#include <string_view>

namespace orbweaver {

struct PictureSize {
    int width = 0;  ///< pixels
    int height = 0;
};

/// "1280x720", each 1 to 16384 and nothing around them; nothing otherwise.
std::optional<PictureSize> parse_picture_size(std::string_view text);

}  // namespace orbweaver
