#include "patch_pass.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "body_light.hpp"
#include "orbweaver/fault.hpp"
#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr std::size_t kStepsAlong = 5;        // of a patch
constexpr std::size_t kStepsAroundTube = 48;  // or more: the rim of a tube of 200 px is straight within 0.2 px

// Points are taken relative to the first of a patch, so that those which are one differ by nothing at all.
constexpr const char* kVertex = R"(#version 330 core
uniform samplerBuffer points;
uniform mat4 view_projection;
uniform ivec2 lattice;  // rings, sides
uniform ivec2 steps;    // of a patch, along and around
out vec3 place;
out vec3 normal;
out vec3 along;         // m, from where the map's rows begin to where they end, if all went on like here
out vec3 around;        // likewise of its columns
out vec2 spot;          // on the map

vec3 point(int ring, int side) {
    return texelFetch(points, (gl_InstanceID * lattice.x + ring) * lattice.y + side % lattice.y).xyz;
}
vec3 middle(int ring) {
    vec3 sum = vec3(0);
    for (int side = 0; side < lattice.y; ++side) sum += point(ring, side) - point(ring, 0);
    return point(ring, 0) + sum / lattice.y;
}
vec4 weights(float t) {
    float s = 1 - t;
    return vec4(s * s * s, (3 * t - 6) * t * t + 4, (3 * s - 6) * s * s + 4, t * t * t) / 6;
}
vec4 slopes(float t) {
    float s = 1 - t;
    return vec4(-s * s, (3 * t - 4) * t, (4 - 3 * s) * s, t * t) / 2;
}
/// Where rings have become a point, skin has no direction of its own: the tube's, outward.
vec3 tip_normal(bool tail) {
    vec3 out_of = tail ? middle(1) - middle(3) : middle(lattice.x - 2) - middle(lattice.x - 4);
    return dot(out_of, out_of) > 0 ? normalize(out_of) : vec3(0, 1, 0);
}
void main() {
    int columns = lattice.y * steps.y + 1, spans = lattice.x - 3;
    ivec2 cell = ivec2(gl_VertexID / columns, gl_VertexID % columns);
    ivec2 patch_at = ivec2(min(cell.x / steps.x, spans - 1), cell.y / steps.y);
    vec2 t = vec2(cell - patch_at * steps) / vec2(steps);
    vec4 by_ring = weights(t.x), by_side = weights(t.y), ring_slope = slopes(t.x), side_slope = slopes(t.y);
    vec3 first = point(patch_at.x, patch_at.y);
    vec3 at = vec3(0);
    along = around = vec3(0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            vec3 p = point(patch_at.x + i, patch_at.y + j + lattice.y - 1) - first;
            at += by_ring[i] * by_side[j] * p;
            along += ring_slope[i] * by_side[j] * p;
            around += by_ring[i] * side_slope[j] * p;
        }
    vec3 outward = cross(around, along);
    bool tip = length(outward) <= 1e-5 * (dot(along, along) + dot(around, around));
    normal = tip ? tip_normal(2 * patch_at.x < spans) : normalize(outward);
    along *= spans;
    around *= lattice.y;
    spot = vec2(cell.y, cell.x) / vec2(lattice.y * steps.y, spans * steps.x);
    place = first + at;
    gl_Position = view_projection * vec4(place, 1);
}
)";

constexpr const char* kFragment = R"(
uniform vec3 eye;
uniform sampler2D map;
uniform float relief;  // m
uniform float gloss;
in vec3 place;
in vec3 normal;
in vec3 along;
in vec3 around;
in vec2 spot;
out vec4 color;
const float kSteepest = 2;  // slope of the relief: where the map is drawn together to a point it has no end

/// How much higher the map is within a texel, over the texel: each a part of the whole.
float slope(vec2 texel) {
    return (texture(map, spot + texel / 2).a - texture(map, spot - texel / 2).a) / (texel.x + texel.y);
}
/// The normal of skin that is raised by the relief (J. F. Blinn, Simulation of Wrinkled Surfaces, 1978).
vec3 raised(vec3 n) {
    vec2 texel = 1.0 / vec2(textureSize(map, 0));
    vec3 uphill = slope(vec2(texel.x, 0)) * cross(along, n) + slope(vec2(0, texel.y)) * cross(n, around);
    uphill *= relief;
    float area = abs(dot(n, cross(around, along)));
    return normalize(n - uphill / max(max(area, length(uphill) / kSteepest), 1e-20));
}
void main() {
    color = vec4(lit_body(texture(map, spot).rgb, gloss, raised(normalize(normal)), normalize(eye - place)), 1);
}
)";

}  // namespace

PatchPass::PatchPass(const Gl& gl, Patches& patches, const SkyLight& light, const KeyLight& key)
    : gl_(gl),
      light_(light),
      key_(key),
      program_(make_program(gl, "patch", kVertex,
                            (std::string("#version 330 core") + kBodyLightSource + kFragment).c_str())),
      vertices_(gl, ObjectKind::vertex_array),
      triangle_buffer_(gl, ObjectKind::buffer),
      map_(gl, ObjectKind::texture) {
    upload_grid(patches.layout());
    upload_map(patches.map());
}

/// The triangles of one tube, as numbers of vertices: row after row from the tail, each once around.
void PatchPass::upload_grid(const PatchLayout& layout) {
    if (layout.rings < 4 || layout.sides < 3) return;
    const std::size_t steps = std::max<std::size_t>((kStepsAroundTube + layout.sides - 1) / layout.sides, 2);
    const std::size_t rows = kStepsAlong * (layout.rings - 3), columns = steps * layout.sides;
    steps_around_ = static_cast<GLint>(steps);
    std::vector<std::uint32_t> corners;
    corners.reserve(6 * rows * columns);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column);
            const auto b = static_cast<std::uint32_t>(a + columns + 1);  // nearer to the head
            for (const std::uint32_t corner : {a, a + 1, b, b, a + 1, b + 1}) corners.push_back(corner);
        }
    corners_ = static_cast<GLsizei>(corners.size());
    const std::size_t bytes = corners.size() * sizeof(std::uint32_t);
    memory_bytes_ += bytes;
    gl_.BindVertexArray(vertices_.name());
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangle_buffer_.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), corners.data(), GL_STATIC_DRAW);
}

void PatchPass::upload_map(const PatchMap& map) {
    GLint most = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::string size = std::to_string(map.columns) + " x " + std::to_string(map.rows);
    if (std::max(map.columns, map.rows) > static_cast<std::uint32_t>(most))
        throw Fault(FaultKind::limit, "A skin's map of " + size +
                                          " texels is larger than this graphics driver draws (" +
                                          std::to_string(most) + " a side); ask for a coarser one.");
    if (map.texels.size() != 4 * std::size_t{map.columns} * map.rows)
        throw Fault(FaultKind::internal,
                    "A skin's map of " + size + " texels has " + std::to_string(map.texels.size()) + " bytes.");
    relief_ = static_cast<float>(map.relief);
    gloss_ = static_cast<float>(map.gloss);
    memory_bytes_ += map.texels.size() * 4 / 3;  // with its coarser levels
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, map_.name());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, static_cast<GLsizei>(map.columns),
                   static_cast<GLsizei>(map.rows), 0, GL_RGBA, GL_UNSIGNED_BYTE, map.texels.data());
    gl_.GenerateMipmap(GL_TEXTURE_2D);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void PatchPass::draw(const PatchPoints& points, const Camera& camera, int width, int height) const {
    const PatchLayout& layout = points.layout();
    if (layout.bodies == 0) return;
    use_body_program(gl_, program_, points.origin(), {camera, width, height}, light_, key_);
    const auto uniform = [&](const char* name) { return gl_.GetUniformLocation(program_.name(), name); };
    gl_.Uniform2i(uniform("lattice"), static_cast<GLint>(layout.rings), static_cast<GLint>(layout.sides));
    gl_.Uniform2i(uniform("steps"), static_cast<GLint>(kStepsAlong), steps_around_);
    gl_.Uniform1f(uniform("relief"), relief_);
    gl_.Uniform1f(uniform("gloss"), gloss_);
    gl_.Uniform1i(uniform("points"), 0);
    gl_.Uniform1i(uniform("map"), 1);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, map_.name());
    points.bind(0);
    gl_.BindVertexArray(vertices_.name());
    draw_bodies(gl_, corners_, static_cast<GLsizei>(layout.bodies));
}

}  // namespace orbweaver::view
