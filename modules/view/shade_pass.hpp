#pragma once

#include "camera.hpp"
#include "skin_moves.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// The soft shade of bodies on a surface. Each of their bones is a rod of radius r, which keeps two lights off
/// a point: of the sky's, at distance d from its axis, about (r / d)^2, as a ball does; of the key light, what
/// its own width covers of a sun that is as wide as 0.12 of its distance. What several keep off is multiplied.
class ShadePass {
public:
    ShadePass(const Gl& gl, const SkinMesh& mesh, const KeyLight& key);
    /// Darkens the bound framebuffer, of width x height pixels, where it shows a surface. `depths` is a texture
    /// of the depths that it holds itself.
    void draw(const SkinMoves& moves, GLuint depths, const Camera& camera, int width, int height) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    const Gl& gl_;
    Vec3 key_;  // unit, towards it
    Object program_;
    Object vertices_;  // none: a box's corners are told by their number
    Object rod_buffer_;
    Object rod_texture_;
    GLint bones_ = 0;
    float cast_ = 0;  // m, how far shadows are thrown
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
