#pragma once

#include <cstdint>
#include <vector>

#include "gl.hpp"

namespace orbweaver::view {

/// An off-screen picture that holds sRGB and blends in linear light.
class FrameTarget {
public:
    /// Throws Fault(internal) when the driver refuses such a framebuffer, Fault(limit) when it is too large.
    FrameTarget(const Gl& gl, int width, int height);

    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }
    /// Makes it what is drawn on.
    void bind() const;
    /// Copies its shades as they are to another framebuffer (0: the canvas's own), scaled to width x height.
    void copy_to(GLuint framebuffer, int width, int height) const;
    GLuint framebuffer() const noexcept { return framebuffer_.name(); }
    /// Writes the picture into `rgb`: 3 bytes a pixel, rows from the top.
    void read(std::vector<std::uint8_t>& rgb);
    std::size_t memory_bytes() const noexcept;

private:
    const Gl* gl_;
    int width_;
    int height_;
    Object texture_;
    Object framebuffer_;
    std::vector<std::uint8_t> rgba_;  // as GL gives it: rows from the bottom
};

}  // namespace orbweaver::view
