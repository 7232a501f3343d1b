#pragma once

#include "camera.hpp"
#include "skin_moves.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// Draws bodies with a skin: one mesh for all of a kind, each vertex moved by its two bones; in the light of
/// all bodies.
class SkinPass {
public:
    SkinPass(const Gl& gl, const SkinMesh& mesh, const SkyLight& light, const KeyLight& key);
    /// Draws on the bound framebuffer, which must hold sRGB with conversion enabled, and depths.
    void draw(const SkinMoves& moves, const Camera& camera, int width, int height) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    void upload(const SkinMesh& mesh);

    const Gl& gl_;
    SkyLight light_;
    KeyLight key_;
    Object program_;
    Object vertices_;
    Object vertex_buffer_;
    Object triangle_buffer_;
    GLsizei corners_ = 0;
    GLint bones_ = 0;
    float grain_ = 1;  // 1/m, of the fine pattern of a skin
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
