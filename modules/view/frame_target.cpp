#include "frame_target.hpp"

#include <algorithm>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::view {

FrameTarget::FrameTarget(const Gl& gl, int width, int height, Depth depth)
    : gl_(&gl),
      width_(width),
      height_(height),
      depth_(depth),
      texture_(gl, ObjectKind::texture),
      framebuffer_(gl, ObjectKind::framebuffer) {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width > largest || height > largest)
        throw Fault(FaultKind::limit, "A picture of " + size +
                                          " pixels is larger than this graphics driver draws (" +
                                          std::to_string(largest) + " a side); ask for a smaller --size.");
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    if (depth == Depth::kept) keep_depths();
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Fault(FaultKind::internal,
                    "The graphics driver refuses an sRGB framebuffer of " + size + " pixels; try --headless.");
}

void FrameTarget::keep_depths() {
    depths_ = Object(*gl_, ObjectKind::texture);
    gl_->BindTexture(GL_TEXTURE_2D, depths_.name());
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width_, height_, 0, GL_DEPTH_COMPONENT,
                    GL_UNSIGNED_INT, nullptr);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.name(), 0);
}

void FrameTarget::bind() const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->Viewport(0, 0, width_, height_);
    gl_->Enable(GL_FRAMEBUFFER_SRGB);
}

void FrameTarget::copy_to(GLuint framebuffer, int width, int height) const {
    gl_->Disable(GL_FRAMEBUFFER_SRGB);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const bool same = width == width_ && height == height_;
    gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                         same ? GL_NEAREST : GL_LINEAR);
}

void FrameTarget::copy_depths_to(const FrameTarget& target) const {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer_.name());
    gl_->BlitFramebuffer(0, 0, width_, height_, 0, 0, target.width_, target.height_, GL_DEPTH_BUFFER_BIT,
                         GL_NEAREST);
}

void FrameTarget::clear_depths() const { gl_->Clear(GL_DEPTH_BUFFER_BIT); }

void FrameTarget::read(std::vector<std::uint8_t>& rgb) {
    const auto w = static_cast<std::size_t>(width_);
    const auto h = static_cast<std::size_t>(height_);
    rgba_.resize(4 * w * h);
    rgb.resize(3 * w * h);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_->ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    for (std::size_t y = 0; y < h; ++y) {
        const std::uint8_t* from = &rgba_[4 * w * (h - 1 - y)];
        std::uint8_t* to = &rgb[3 * w * y];
        for (std::size_t x = 0; x < w; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
    }
}

std::size_t FrameTarget::memory_bytes() const noexcept {
    const std::size_t pixel = depth_ == Depth::kept ? 8 : 4;
    return pixel * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + rgba_.capacity();
}

}  // namespace orbweaver::view
