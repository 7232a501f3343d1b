#include "shade_pass.hpp"

#include <string>

#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr float kReach = 6;       // radii, how far a rod keeps off the sky's light
constexpr float kChainReach = 3;  // less: rods in a row are thick ones, whose boxes would fill the picture

constexpr const char* kVertex = R"(
uniform mat4 view_projection;
uniform vec4 key;    // towards it; m, how far shadows are thrown
flat out vec4 from;  // m, and radius
flat out vec3 to;
uniform float reach;  // radii, how far shade goes
void main() {
    find_rod(gl_InstanceID, from, to);

    // A box around rod and shadow: z towards the key light, and no extent of the rod's along y.
    vec3 along = to - from.xyz;
    vec3 level = along - dot(along, key.xyz) * key.xyz;
    if (length(level) < 1e-9) level = cross(key.xyz, abs(key.y) < 0.7 ? vec3(0, 1, 0) : vec3(1, 0, 0));
    mat3 axes = mat3(normalize(level), cross(key.xyz, normalize(level)), key.xyz);
    vec3 ends = along * axes;  // in the box's frame, from `from`
    float wide = reach * from.w;
    vec3 low = min(ends, 0) - vec3(wide, wide, max(wide, key.w)), high = max(ends, 0) + wide;

    // Its twelve triangles: of face f, whose axis is f / 2, corners (-,-) (+,-) (+,+) and (-,-) (+,+) (-,+).
    int face = gl_VertexID / 6, corner = gl_VertexID % 6;
    float side = (face & 1) == 0 ? -1 : 1;
    float s = corner == 1 || corner == 2 || corner == 4 ? side : -side;  // all wound alike
    float t = corner == 2 || corner == 4 || corner == 5 ? 1 : -1;
    vec3 at = face / 2 == 0 ? vec3(side, s, t) : face / 2 == 1 ? vec3(t, side, s) : vec3(s, t, side);
    gl_Position = view_projection * vec4(from.xyz + axes * mix(low, high, 0.5 + 0.5 * at), 1);
    if (from.w == 0) gl_Position = vec4(2, 2, 2, 1);
}
)";

constexpr const char* kFragment = R"(#version 330 core
uniform sampler2D depths;
uniform vec2 size;     // px
uniform vec2 clip;     // m, near and far
uniform vec3 eye;
uniform vec3 forward;  // unit
uniform vec3 right;    // to the picture's rim, at a depth of 1
uniform vec3 up;
uniform vec4 key;
uniform bool chained;
flat in vec4 from;
flat in vec3 to;
out vec4 color;
uniform float reach;
const float kWidth = 0.12;
const float kOfSky = 0.6, kOfKey = 0.5;  // how dark it gets

float kept_of_sky(vec3 at, vec3 along) {
    float share = dot(at, along) / dot(along, along), part = 1;
    if (chained) {  // what of an endless rod's it keeps off: rods in a row sum up to one
        float wide = max(distance(at, share * along), from.w), span = length(along);
        vec2 ends = vec2(share, 1 - share) * span;
        part = 0.5 * (ends.x / length(vec2(ends.x, wide)) + ends.y / length(vec2(ends.y, wide)));
    } else
        share = clamp(share, 0, 1);
    float away = distance(at, share * along) / from.w;
    return part * min(max(1 / (away * away + 0.3) - 1 / (reach * reach + 0.3), 0), 1);
}

/// Where the ray to the key light passes the rod.
float kept_of_key(vec3 at, vec3 along) {
    float b = dot(key.xyz, along), c = dot(along, along), d = dot(key.xyz, at);
    float share = (dot(along, at) - d * b) / max(c - b * b, 1e-6 * c), far = share * b - d;
    if (far < 0 || far > key.w) return 0.0;
    float soft = 0.5 * kWidth * far + 0.1 * from.w, span = sqrt(c);
    float past = length(at + far * key.xyz - share * along);
    float across = clamp((from.w + soft - past) / (2 * min(soft, from.w)), 0, 1) * min(1, from.w / soft);
    float ramp = 2 * soft + 1.4 * from.w;  // at their ends rods that are joined keep off a half each
    vec2 ends = clamp(0.5 + vec2(share, 1 - share) * span / ramp, 0, 1);
    float within = chained ? ends.x + ends.y - 1 : ends.x * ends.y;  // so do short ones in a row
    return across * within * min(2 - 2 * far / key.w, 1);
}

void main() {
    float z = 2 * texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r - 1;
    float depth = 2 * clip.x * clip.y / (clip.y + clip.x - z * (clip.y - clip.x));
    vec2 screen = 2 * gl_FragCoord.xy / size - 1;
    vec3 place = eye + depth * (forward + screen.x * right + screen.y * up);
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    if (dot(normal, eye - place) < 0) normal = -normal;
    vec3 at = place - from.xyz, along = to - from.xyz;
    float lit = clamp(1.6 * dot(normal, key.xyz), 0, 1);
    float left = (1 - kOfSky * kept_of_sky(at, along)) * (1 - kOfKey * lit * kept_of_key(at, along));
    color = vec4(vec3(left), 1);
}
)";

}  // namespace

ShadePass::ShadePass(const Gl& gl, const char* rod_source, Joints joints, const KeyLight& key)
    : gl_(gl),
      key_(key.direction),
      chained_(joints == Joints::chained),
      program_(make_program(gl, "shade", (std::string("#version 330 core") + rod_source + kVertex).c_str(),
                            kFragment)),
      vertices_(gl, ObjectKind::vertex_array) {}

void ShadePass::draw(const ShadeRods& rods, GLuint depths, const Camera& camera, int width, int height) const {
    if (rods.count == 0) return;
    const Camera local{camera.position - rods.origin, camera.target - rods.origin, camera.fov_degrees};
    const auto [near, far] = clip_depths(camera);
    const double aspect = static_cast<double>(width) / height;
    const auto matrix = view_projection(local, aspect, near, far);
    const CameraAxes of = axes(camera);
    const auto uniform = [&](const char* name) { return gl_.GetUniformLocation(program_.name(), name); };
    const auto vector = [&](const char* name, const Vec3& v) {
        gl_.Uniform3f(uniform(name), static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
    };
    gl_.UseProgram(program_.name());
    gl_.UniformMatrix4fv(uniform("view_projection"), 1, GL_FALSE, matrix.data());
    gl_.Uniform2f(uniform("size"), static_cast<float>(width), static_cast<float>(height));
    gl_.Uniform2f(uniform("clip"), static_cast<float>(near), static_cast<float>(far));
    vector("eye", local.position);
    vector("forward", of.forward);
    vector("right", half_height(camera) * aspect * of.right);
    vector("up", half_height(camera) * of.up);
    gl_.Uniform4f(uniform("key"), static_cast<float>(key_.x), static_cast<float>(key_.y),
                  static_cast<float>(key_.z), static_cast<float>(rods.cast));
    gl_.Uniform1i(uniform("bones"), rods.a_body);
    gl_.Uniform1i(uniform("chained"), chained_ ? 1 : 0);
    gl_.Uniform1f(uniform("reach"), chained_ ? kChainReach : kReach);
    gl_.Uniform1i(uniform("moves"), 0);
    gl_.Uniform1i(uniform("rods"), 1);
    gl_.Uniform1i(uniform("depths"), 2);
    gl_.ActiveTexture(GL_TEXTURE2);
    gl_.BindTexture(GL_TEXTURE_2D, depths);
    gl_.BindVertexArray(vertices_.name());
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_DST_COLOR, GL_ZERO);
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_FRONT);     // far sides: they are there when the camera is in the box, too
    gl_.Enable(GL_DEPTH_TEST);  // what they do not cover is beyond the box
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_FALSE);
    gl_.DrawArraysInstanced(GL_TRIANGLES, 0, 36, rods.count);
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LESS);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.ActiveTexture(GL_TEXTURE0);
}

}  // namespace orbweaver::view
