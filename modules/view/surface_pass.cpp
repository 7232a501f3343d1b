#include "surface_pass.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "picture/color.hpp"
#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr const char* kVertex = R"(#version 330 core
uniform samplerBuffer points;
uniform mat4 view_projection;
layout(location = 0) in uint corner;  // vertex * 16 + glass * 8 + edges
flat out uint edges;
flat out uint glass;
out vec3 weights;
out vec3 place;
void main() {
    edges = corner & 7u;
    glass = corner >> 3u & 1u;
    int which = gl_VertexID % 3;
    weights = vec3(which == 0, which == 1, which == 2);
    place = texelFetch(points, int(corner >> 4u)).xyz;
    gl_Position = view_projection * vec4(place, 1);
}
)";

constexpr const char* kFragment = R"(#version 330 core
uniform vec3 eye;
uniform vec3 light[6];  // from +x, -x, +y, -y, -z, +z
uniform vec4 look;      // linear color, opacity of edges
flat in uint edges;
flat in uint glass;
in vec3 weights;
in vec3 place;
out vec4 color;
void main() {
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    if (dot(normal, eye - place) < 0) normal = -normal;
    vec3 part = normal * normal;
    vec3 lit = part.x * (normal.x > 0 ? light[0] : light[1]) + part.y * (normal.y > 0 ? light[2] : light[3]) +
               part.z * (normal.z < 0 ? light[4] : light[5]);
    vec3 away = weights.zxy / fwidth(weights.zxy);  // px from each edge
    float nearest = 1e9;
    for (int e = 0; e < 3; ++e)
        if ((edges >> uint(e) & 1u) != 0u) nearest = min(nearest, away[e]);
    float line = look.a * clamp(1.5 - nearest, 0, 1);
    vec3 shade = look.rgb * (glass != 0u ? vec3(0.35, 0.62, 0.72) : vec3(1));
    color = vec4(shade * lit * (1 - line), 1);
}
)";

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the lower vertex first

Edge edge_of(const std::array<std::uint32_t, 3>& face, std::size_t edge) {
    return std::minmax({face[edge], face[(edge + 1) % 3]});
}

}  // namespace

std::vector<std::uint32_t> corner_codes(const Surface& surface) {
    const auto faces = surface.faces();
    const auto polygons = surface.polygons();
    std::vector<std::uint32_t> codes;
    codes.reserve(3 * faces.size());
    std::vector<Edge> inside;
    for (std::size_t first = 0; first < faces.size();) {
        std::size_t end = first;
        inside.clear();
        for (; end < faces.size() && polygons[end] == polygons[first]; ++end)
            for (std::size_t edge = 0; edge < 3; ++edge) inside.push_back(edge_of(faces[end], edge));
        std::sort(inside.begin(), inside.end());
        for (; first < end; ++first) {
            std::uint32_t ends = 0;
            for (std::uint32_t edge = 0; edge < 3; ++edge) {
                const auto [low, high] =
                    std::equal_range(inside.begin(), inside.end(), edge_of(faces[first], edge));
                if (high - low == 1) ends |= 1U << edge;
            }
            const std::uint32_t glass = surface.grip(static_cast<std::uint32_t>(first)).climbable ? 0 : 8;
            for (const std::uint32_t vertex : faces[first]) codes.push_back(vertex * 16 + glass + ends);
        }
    }
    return codes;
}

SurfacePass::SurfacePass(const Gl& gl, const Surface& surface, const SurfaceLook& look, const SkyLight& light)
    : gl_(gl),
      look_(look),
      light_(light),
      program_(make_program(gl, "surface", kVertex, kFragment)),
      vertices_(gl, ObjectKind::vertex_array),
      corner_buffer_(gl, ObjectKind::buffer),
      point_buffer_(gl, ObjectKind::buffer),
      point_texture_(gl, ObjectKind::texture),
      origin_(middle(surface.vertices())) {
    std::vector<float> points;
    points.reserve(4 * surface.vertices().size());
    for (const Vec3& vertex : surface.vertices()) {
        const Vec3 p = vertex - origin_;
        for (const double x : {p.x, p.y, p.z, 1.0}) points.push_back(static_cast<float>(x));
    }
    const auto codes = corner_codes(surface);
    corners_ = static_cast<GLsizei>(codes.size());
    memory_bytes_ = sizeof(float) * points.size() + sizeof(std::uint32_t) * codes.size();

    gl.BindVertexArray(vertices_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, corner_buffer_.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(std::uint32_t) * codes.size()), codes.data(),
                  GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribIPointer(0, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t), nullptr);
    gl.BindBuffer(GL_TEXTURE_BUFFER, point_buffer_.name());
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(sizeof(float) * points.size()), points.data(),
                  GL_STATIC_DRAW);
    gl.BindTexture(GL_TEXTURE_BUFFER, point_texture_.name());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, point_buffer_.name());
}

void SurfacePass::draw(const Camera& camera, int width, int height) const {
    const Camera local{camera.position - origin_, camera.target - origin_, camera.fov_degrees};
    const auto [near, far] = clip_depths(camera);
    const auto matrix = view_projection(local, static_cast<double>(width) / height, near, far);
    const auto uniform = [&](const std::string& name) {
        return gl_.GetUniformLocation(program_.name(), name.c_str());
    };
    const auto shade = [](double s) { return picture::linear_from_srgb(static_cast<float>(s)); };

    gl_.UseProgram(program_.name());
    gl_.UniformMatrix4fv(uniform("view_projection"), 1, GL_FALSE, matrix.data());
    gl_.Uniform3f(uniform("eye"), static_cast<float>(local.position.x), static_cast<float>(local.position.y),
                  static_cast<float>(local.position.z));
    for (std::size_t f = 0; f < kFaces; ++f)
        gl_.Uniform3f(uniform("light[" + std::to_string(f) + "]"), light_[f][0], light_[f][1], light_[f][2]);
    gl_.Uniform4f(uniform("look"), shade(look_.color.x), shade(look_.color.y), shade(look_.color.z),
                  static_cast<float>(look_.edges));
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_BUFFER, point_texture_.name());
    gl_.BindVertexArray(vertices_.name());
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DrawArrays(GL_TRIANGLES, 0, corners_);
    gl_.Disable(GL_DEPTH_TEST);
}

}  // namespace orbweaver::view
