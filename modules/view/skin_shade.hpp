#pragma once

#include "shade_pass.hpp"
#include "skin_moves.hpp"

namespace orbweaver::view {

/// The shade of bodies with a skin: of their bones.
class SkinShade {
public:
    SkinShade(const Gl& gl, const SkinMesh& mesh, const KeyLight& key);
    /// As ShadePass::draw.
    void draw(const SkinMoves& moves, GLuint depths, const Camera& camera, int width, int height) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    ShadePass pass_;
    TexelBuffer rods_;
    GLint bones_ = 0;
    double cast_ = 0;  // m, how far shadows are thrown
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
