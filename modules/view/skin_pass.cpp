#include "skin_pass.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "body_light.hpp"
#include "picture/color.hpp"
#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr const char* kVertex = R"(
uniform mat4 view_projection;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 outward;
layout(location = 2) in vec4 paint;  // linear color, gloss
layout(location = 3) in uvec2 bone;
layout(location = 4) in vec2 weight;
out vec3 rest;
out vec3 place;
out vec3 normal;
out vec4 look;
void main() {
    rest = position;
    look = paint;
    place = normal = vec3(0);
    for (int i = 0; i < 2; ++i) {
        place += weight[i] * moved(gl_InstanceID, int(bone[i]), vec4(position, 1));
        normal += weight[i] * moved(gl_InstanceID, int(bone[i]), vec4(outward, 0));
    }
    gl_Position = view_projection * vec4(place, 1);
}
)";

constexpr const char* kFragment = R"(
uniform vec3 eye;
uniform float grain;
in vec3 rest;
in vec3 place;
in vec3 normal;
in vec4 look;
out vec4 color;

float chance(vec3 cell) { return fract(sin(dot(cell, vec3(127.1, 311.7, 74.7))) * 43758.5453); }
float noise(vec3 p) {
    vec3 cell = floor(p), t = fract(p);
    t = t * t * (3 - 2 * t);
    vec4 low, high;
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(i & 1, i >> 1);
        low[i] = chance(cell + vec3(corner, 0));
        high[i] = chance(cell + vec3(corner, 1));
    }
    vec4 z = mix(low, high, t.z);
    vec2 y = mix(z.xy, z.zw, t.y);
    return mix(y.x, y.y, t.x);
}
void main() {
    float gloss = look.a, dull = 1 - gloss;
    float mottle = 0.6 * noise(rest * grain) + 0.4 * noise(rest * grain * 2.7);
    vec3 skin = look.rgb * mix(1, 0.55 + 0.9 * mottle, dull);
    color = vec4(lit_body(skin, gloss, normalize(normal), normalize(eye - place)), 1);
}
)";

/// A vertex as the shader reads it.
struct Packed {
    std::array<float, 3> position, normal;
    std::array<float, 4> paint;
    std::array<std::uint32_t, 2> bones;
    std::array<float, 2> weights;
};

Packed packed(const SkinVertex& v) {
    const auto light = [](float shade) { return picture::linear_from_srgb(shade); };
    return {v.position,
            v.normal,
            {light(v.color[0]), light(v.color[1]), light(v.color[2]), v.gloss},
            v.bones,
            v.weights};
}

}  // namespace

SkinPass::SkinPass(const Gl& gl, const SkinMesh& mesh, const SkyLight& light, const KeyLight& key)
    : gl_(gl),
      light_(light),
      key_(key),
      program_(make_program(gl, "skin", (std::string("#version 330 core") + kMovedSource + kVertex).c_str(),
                            (std::string("#version 330 core") + kBodyLightSource + kFragment).c_str())),
      vertices_(gl, ObjectKind::vertex_array),
      vertex_buffer_(gl, ObjectKind::buffer),
      triangle_buffer_(gl, ObjectKind::buffer) {
    upload(mesh);
}

void SkinPass::upload(const SkinMesh& mesh) {
    constexpr float kGrains = 90;  // along the mesh's longest side
    std::vector<Packed> all;
    all.reserve(mesh.vertices.size());
    float low = 0, high = 0;
    for (const SkinVertex& vertex : mesh.vertices) {
        all.push_back(packed(vertex));
        low = std::min(low, vertex.position[0]);
        high = std::max(high, vertex.position[0]);
    }
    if (high > low) grain_ = kGrains / (high - low);
    corners_ = static_cast<GLsizei>(3 * mesh.triangles.size());
    bones_ = static_cast<GLint>(mesh.rods.size());
    memory_bytes_ = sizeof(Packed) * all.size() + mesh.triangles.size_bytes();

    gl_.BindVertexArray(vertices_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(Packed) * all.size()), all.data(),
                   GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangle_buffer_.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size_bytes()),
                   mesh.triangles.data(), GL_STATIC_DRAW);
    const auto floats = [&](GLuint where, GLint count, std::size_t at) {
        gl_.EnableVertexAttribArray(where);
        gl_.VertexAttribPointer(where, count, GL_FLOAT, GL_FALSE, sizeof(Packed), buffer_offset(at));
    };
    floats(0, 3, offsetof(Packed, position));
    floats(1, 3, offsetof(Packed, normal));
    floats(2, 4, offsetof(Packed, paint));
    gl_.EnableVertexAttribArray(3);
    gl_.VertexAttribIPointer(3, 2, GL_UNSIGNED_INT, sizeof(Packed), buffer_offset(offsetof(Packed, bones)));
    floats(4, 2, offsetof(Packed, weights));
}

void SkinPass::draw(const SkinMoves& moves, const Camera& camera, int width, int height) const {
    if (moves.creatures() == 0) return;
    use_body_program(gl_, program_, moves.origin(), {camera, width, height}, light_, key_);
    const auto uniform = [&](const char* name) { return gl_.GetUniformLocation(program_.name(), name); };
    gl_.Uniform1f(uniform("grain"), grain_);
    gl_.Uniform1i(uniform("moves"), 0);
    gl_.Uniform1i(uniform("bones"), bones_);
    moves.bind(0);
    gl_.BindVertexArray(vertices_.name());
    draw_bodies(gl_, corners_, moves.creatures());
}

}  // namespace orbweaver::view
