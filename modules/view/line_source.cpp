#include "line_source.hpp"

namespace orbweaver::view {

const char* const kLineSource = R"(
bool cut_near(inout vec4 a, inout vec4 b, float near) {
    if (a.w < near && b.w < near) return false;
    if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
    if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
    return true;
}
vec4 line_corner(vec4 a, vec4 b, vec2 half_size, vec2 reach, out float across) {
    vec2 pa = a.xy / a.w * half_size;
    vec2 pb = b.xy / b.w * half_size;
    float length_px = distance(pa, pb);
    vec2 along = length_px > 1e-5 ? (pb - pa) / length_px : vec2(1, 0);
    bool at_a = gl_VertexID < 2;
    across = ((gl_VertexID & 1) == 0 ? -1 : 1) * (at_a ? reach.x : reach.y);
    vec2 corner = (at_a ? pa : pb) + across * vec2(-along.y, along.x);
    vec4 end = at_a ? a : b;
    return vec4(corner / half_size, end.z / end.w, 1);
}
)";

}  // namespace orbweaver::view
