#pragma once

namespace orbweaver::view {

/// GLSL of lines as quads that face the camera:
///   bool cut_near(inout vec4 a, inout vec4 b, float near)  clip coordinates; false: all of it is nearer
///   vec4 line_corner(vec4 a, vec4 b, vec2 half_size, vec2 reach, out float across)  of vertex 0 to 3; `reach`
///     px from the axis at a and at b; `half_size` of the picture, px
extern const char* const kLineSource;

}  // namespace orbweaver::view
