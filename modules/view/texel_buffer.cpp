#include "texel_buffer.hpp"

namespace orbweaver::view {

void TexelBuffer::upload(std::span<const float> texels, GLenum usage, GLenum unit) const {
    gl_.BindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    gl_.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size_bytes()), texels.data(), usage);
    bind(unit);
    gl_.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.name());
}

void TexelBuffer::bind(GLenum unit) const {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
}

}  // namespace orbweaver::view
