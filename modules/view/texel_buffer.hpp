#pragma once

#include <span>

#include "gl.hpp"

namespace orbweaver::view {

/// Numbers that shaders read as a texture of texels of four floats.
class TexelBuffer {
public:
    explicit TexelBuffer(const Gl& gl)
        : gl_(gl), buffer_(gl, ObjectKind::buffer), texture_(gl, ObjectKind::texture) {}

    /// Other numbers than before; `usage` as glBufferData has it. Binds GL_TEXTURE0 + unit.
    void upload(std::span<const float> texels, GLenum usage, GLenum unit) const;
    /// Makes it the texture of GL_TEXTURE0 + unit.
    void bind(GLenum unit) const;

private:
    const Gl& gl_;
    Object buffer_;
    Object texture_;
};

}  // namespace orbweaver::view
