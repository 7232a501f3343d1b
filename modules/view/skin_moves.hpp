#pragma once

#include <vector>

#include "gl.hpp"
#include "orbweaver/contracts/skins.hpp"
#include "texel_buffer.hpp"

namespace orbweaver::view {

/// Where the bones of a provider's creatures are now, as shaders read it: a texture of three texels a bone, the
/// rows of its move.
class SkinMoves {
public:
    SkinMoves(const Gl& gl, Skins& skins);
    /// Asks the provider anew.
    void update();
    /// Makes it the texture of GL_TEXTURE0 + unit.
    void bind(GLenum unit) const { buffer_.bind(unit); }

    GLsizei creatures() const noexcept { return creatures_; }
    const Vec3& origin() const noexcept { return origin_; }
    std::size_t memory_bytes() const noexcept { return 2 * rows_.capacity() * sizeof(float); }

private:
    Skins& skins_;
    TexelBuffer buffer_;
    std::vector<float> rows_;
    Vec3 origin_;  // m, so that floats keep their digits far from the scene's origin
    GLsizei creatures_ = 0;
};

/// GLSL: `vec3 moved(int creature, int bone, vec4 rest)`, with w = 1 a point, with w = 0 a direction.
extern const char* const kMovedSource;

}  // namespace orbweaver::view
