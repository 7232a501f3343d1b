#pragma once

#include "camera.hpp"
#include "gl.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// GLSL of fragments of bodies, whatever their skin is made of:
///   vec3 lit_body(vec3 paint, float gloss, vec3 n, vec3 v)  what the eye sees of a linear color; n unit,
///   outward;
///     v unit, towards the eye
/// Light is the sky's six directions and its key light, which is not shadowed; dull skin has a sheen towards
/// its rims, as hair has, polished skin shows the key light and the sky.
extern const char* const kBodyLightSource;

/// A picture that bodies are drawn in.
struct BodyPicture {
    const Camera& camera;
    int width = 0, height = 0;  ///< pixels
};

/// Uses `program`, whose uniforms `view_projection` and `eye` are told, relative to `origin` (m), and those of
/// light.
void use_body_program(const Gl& gl, const Object& program, const Vec3& origin, const BodyPicture& picture,
                      const SkyLight& light, const KeyLight& key);

/// Draws `corners` indices of triangles once for each body: what faces the eye, and nothing is before.
void draw_bodies(const Gl& gl, GLsizei corners, GLsizei bodies);

}  // namespace orbweaver::view
