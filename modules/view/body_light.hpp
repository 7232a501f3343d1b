#pragma once

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

/// Tells its uniforms to `program`, which must be in use.
void send_body_light(const Gl& gl, const Object& program, const SkyLight& light, const KeyLight& key);

}  // namespace orbweaver::view
