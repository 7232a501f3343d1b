#pragma once

#include "camera.hpp"
#include "gl.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// Rods that throw shade, as they are now.
struct ShadeRods {
    GLsizei count = 0;
    GLint a_body = 0;  ///< how many of them are one body's, where `rod_source` asks
    Vec3 origin;       ///< m, which they are told relative to
    double cast = 0;   ///< m, how far shadows are thrown
};

/// How the rods of a body go on from each other. Each of loose ones shades as if it were alone; chained ones,
/// each of which ends where the next begins, shade as one rod that bends does, however many there are of them.
enum class Joints { loose, chained };

/// The soft shade of bodies on a surface. Each of their rods, of radius r, keeps two lights off a point: of the
/// sky's, at distance d from its axis, about (r / d)^2, as a ball does; of the key light, what its own width
/// covers of a sun that is as wide as 0.12 of its distance. What several keep off is multiplied.
class ShadePass {
public:
    /// `rod_source` is GLSL: `void find_rod(int i, out vec4 from, out vec3 to)`, both ends (m) and the radius
    /// in from.w, 0: no shade. It reads buffer textures `moves`, of GL_TEXTURE0, and `rods`, of GL_TEXTURE1,
    /// and `uniform int bones`, which is how many rods a body has.
    ShadePass(const Gl& gl, const char* rod_source, Joints joints, const KeyLight& key);
    /// Darkens the bound framebuffer, of width x height pixels, where it shows a surface. `depths` is a texture
    /// of the depths that it holds itself. What `rod_source` reads must be bound.
    void draw(const ShadeRods& rods, GLuint depths, const Camera& camera, int width, int height) const;

private:
    const Gl& gl_;
    Vec3 key_;  // unit, towards it
    bool chained_;
    Object program_;
    Object vertices_;  // none: a box's corners are told by their number
};

}  // namespace orbweaver::view
