#pragma once

#include <cstdint>
#include <span>

namespace orbweaver {

/// Whoever has just drawn a picture.
class PictureSource {
public:
    static constexpr const char* kContract = "picture_source/1";

    virtual int width() const noexcept = 0;
    virtual int height() const noexcept = 0;
    /// The latest picture: sRGB, 3 bytes a pixel, rows from the top, no padding. Read back from the
    /// canvas on the first call after it was drawn.
    virtual std::span<const std::uint8_t> rgb() noexcept = 0;

protected:
    ~PictureSource() = default;
};

}  // namespace orbweaver
