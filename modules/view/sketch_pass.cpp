#include "sketch_pass.hpp"

#include <string>

#include "line_source.hpp"
#include "picture/color.hpp"
#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr const char* kVertex = R"(
uniform mat4 view_projection;
uniform vec2 half_size;  // px
uniform float near;      // m
layout(location = 0) in vec3 begin;
layout(location = 1) in vec3 end;
layout(location = 2) in vec3 light;
out float across;        // px from the axis
flat out vec3 shade;
const float kReach = 2;
void main() {
    shade = light;
    across = 0;
    vec4 a = view_projection * vec4(begin, 1), b = view_projection * vec4(end, 1);
    gl_Position = vec4(2, 2, 2, 1);
    if (cut_near(a, b, near)) gl_Position = line_corner(a, b, half_size, vec2(kReach), across);
}
)";

constexpr const char* kFragment = R"(#version 330 core
in float across;
flat in vec3 shade;
out vec4 color;
void main() { color = vec4(shade, clamp(2 - abs(across), 0, 1)); }
)";

constexpr GLsizei kLineBytes = 9 * sizeof(float);

}  // namespace

SketchPass::SketchPass(const Gl& gl, Sketch& sketch)
    : gl_(gl),
      sketch_(sketch),
      program_(make_program(gl, "sketch", (std::string("#version 330 core") + kLineSource + kVertex).c_str(),
                            kFragment)),
      vertices_(gl, ObjectKind::vertex_array),
      line_buffer_(gl, ObjectKind::buffer) {}

void SketchPass::draw(const Camera& camera, int width, int height) {
    const auto lines = sketch_.lines();
    if (lines.empty()) return;
    const Vec3 origin = lines.front().a;  // so that floats keep their digits far from the scene's
    numbers_.clear();
    for (const SketchLine& line : lines) {
        for (const Vec3& end : {line.a - origin, line.b - origin})
            for (const double x : {end.x, end.y, end.z}) numbers_.push_back(static_cast<float>(x));
        for (const float shade : line.color) numbers_.push_back(picture::linear_from_srgb(shade));
    }
    const Camera local{camera.position - origin, camera.target - origin, camera.fov_degrees};
    const auto [near, far] = clip_depths(camera);
    const auto matrix = view_projection(local, static_cast<double>(width) / height, near, far);
    const auto uniform = [&](const char* name) { return gl_.GetUniformLocation(program_.name(), name); };

    gl_.UseProgram(program_.name());
    gl_.UniformMatrix4fv(uniform("view_projection"), 1, GL_FALSE, matrix.data());
    gl_.Uniform2f(uniform("half_size"), static_cast<float>(width) / 2, static_cast<float>(height) / 2);
    gl_.Uniform1f(uniform("near"), static_cast<float>(near));
    gl_.BindVertexArray(vertices_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, line_buffer_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers_.size() * sizeof(float)), numbers_.data(),
                   GL_STREAM_DRAW);
    for (GLuint i = 0; i < 3; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, kLineBytes, buffer_offset(3 * sizeof(float) * i));
        gl_.VertexAttribDivisor(i, 1);
    }
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.size()));
}

}  // namespace orbweaver::view
