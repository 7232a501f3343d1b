#pragma once

#include <cstdint>
#include <vector>

#include "gl.hpp"

namespace orbweaver::view {

/// An off-screen picture that holds sRGB and blends in linear light.
class FrameTarget {
public:
    enum class Depth { none, kept };
    /// Throws Fault(internal) when the driver refuses such a framebuffer, Fault(limit) when it is too large.
    FrameTarget(const Gl& gl, int width, int height, Depth depth = Depth::none);

    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }
    /// Makes it what is drawn on.
    void bind() const;
    /// Copies its shades as they are to another framebuffer (0: the canvas's own), scaled to width x height.
    void copy_to(GLuint framebuffer, int width, int height) const;
    /// Copies its depths to another target that keeps some.
    void copy_depths_to(const FrameTarget& target) const;
    /// Everything infinitely far, where depths are kept; it must be bound.
    void clear_depths() const;
    /// Its depths as a texture, 0 when none are kept. Not while it is drawn on.
    GLuint depths() const noexcept { return depths_.name(); }
    GLuint framebuffer() const noexcept { return framebuffer_.name(); }
    /// Writes the picture into `rgb`: 3 bytes a pixel, rows from the top.
    void read(std::vector<std::uint8_t>& rgb);
    std::size_t memory_bytes() const noexcept;

private:
    void keep_depths();

    const Gl* gl_;
    int width_;
    int height_;
    Depth depth_;
    Object texture_;
    Object depths_;  // nothing when none are kept
    Object framebuffer_;
    std::vector<std::uint8_t> rgba_;  // as GL gives it: rows from the bottom
};

}  // namespace orbweaver::view
