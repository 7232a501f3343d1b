#include "thread_pass.hpp"

#include <string>

#include "line_source.hpp"
#include "picture/color.hpp"
#include "shader.hpp"

namespace orbweaver::view {
namespace {

constexpr const char* kVertex = R"(
uniform samplerBuffer points;
uniform mat4 view_projection;
uniform vec2 half_size;     // px
uniform vec2 width_near;    // thread width times focal length, m px; depth of the near plane, m
layout(location = 0) in uvec4 thread;  // a ThreadSegment
out float across;           // px from the axis
out float reach;            // px from the axis at which coverage ends
out float fill;             // opacity left to a thread thinner than a pixel
void main() {
    vec4 a = view_projection * vec4(texelFetch(points, int(thread.x)).xyz, 1);
    vec4 b = view_projection * vec4(texelFetch(points, int(thread.y)).xyz, 1);
    across = reach = fill = 0;
    gl_Position = vec4(2, 2, 2, 1);
    if (!cut_near(a, b, width_near.y)) return;
    vec2 widths = uintBitsToFloat(thread.w) * width_near.x / vec2(a.w, b.w);
    vec2 reaches = 0.5 * (max(widths, 1) + 1);
    gl_Position = line_corner(a, b, half_size, reaches, across);
    bool at_a = gl_VertexID < 2;
    reach = at_a ? reaches.x : reaches.y;
    fill = min(at_a ? widths.x : widths.y, 1);
}
)";

constexpr const char* kFragment = R"(#version 330 core
uniform vec4 look;          // linear color, alpha
in float across;
in float reach;
in float fill;
out vec4 color;
void main() { color = vec4(look.rgb, look.a * fill * clamp(reach - abs(across), 0, 1)); }
)";

GLint uniform(const Gl& gl, const Object& program, const char* name) {
    return gl.GetUniformLocation(program.name(), name);
}

}  // namespace

ThreadPass::ThreadPass(const Gl& gl, const Threads& threads, const ThreadLook& look)
    : gl_(gl),
      threads_(threads),
      look_(look),
      program_(make_program(gl, "thread", (std::string("#version 330 core") + kLineSource + kVertex).c_str(),
                            kFragment)),
      vertices_(gl, ObjectKind::vertex_array),
      segment_buffer_(gl, ObjectKind::buffer),
      point_buffer_(gl, ObjectKind::buffer),
      point_texture_(gl, ObjectKind::texture) {}

std::size_t ThreadPass::memory_bytes() const noexcept {
    return 2 * points_.size() * sizeof(float) + threads_.segments().size() * sizeof(ThreadSegment);
}

void ThreadPass::upload_segments() {
    const auto segments = threads_.segments();
    gl_.BindVertexArray(vertices_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, segment_buffer_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(segments.size_bytes()), segments.data(),
                   GL_STATIC_DRAW);
    gl_.EnableVertexAttribArray(0);
    static_assert(sizeof(ThreadSegment) == 4 * sizeof(GLuint));
    gl_.VertexAttribIPointer(0, 4, GL_UNSIGNED_INT, sizeof(ThreadSegment), nullptr);
    gl_.VertexAttribDivisor(0, 1);
    revision_ = threads_.revision();
    uploaded_ = true;
}

void ThreadPass::upload_points() {
    const auto points = threads_.points();
    origin_ = points.front();
    points_.resize(4 * points.size());
    float* to = points_.data();
    for (const Vec3& point : points) {
        const Vec3 p = point - origin_;
        *to++ = static_cast<float>(p.x);
        *to++ = static_cast<float>(p.y);
        *to++ = static_cast<float>(p.z);
        *to++ = 1;
    }
    gl_.BindBuffer(GL_TEXTURE_BUFFER, point_buffer_.name());
    gl_.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(points_.size() * sizeof(float)), points_.data(),
                   GL_STREAM_DRAW);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_BUFFER, point_texture_.name());
    gl_.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, point_buffer_.name());
}

void ThreadPass::draw(const Camera& camera, int width, int height) {
    if (threads_.segments().empty() || threads_.points().empty()) return;
    if (!uploaded_ || revision_ != threads_.revision()) upload_segments();
    upload_points();

    const Camera local{camera.position - origin_, camera.target - origin_, camera.fov_degrees};
    const auto [near, far] = clip_depths(camera);
    const auto matrix = view_projection(local, static_cast<double>(width) / height, near, far);
    const double focal = height / (2 * half_height(camera));
    const auto light = [](double shade) { return picture::linear_from_srgb(static_cast<float>(shade)); };

    gl_.UseProgram(program_.name());
    gl_.UniformMatrix4fv(uniform(gl_, program_, "view_projection"), 1, GL_FALSE, matrix.data());
    gl_.Uniform2f(uniform(gl_, program_, "half_size"), static_cast<float>(width) / 2,
                  static_cast<float>(height) / 2);
    gl_.Uniform2f(uniform(gl_, program_, "width_near"), static_cast<float>(look_.width * focal),
                  static_cast<float>(near));
    gl_.Uniform4f(uniform(gl_, program_, "look"), light(look_.color.x), light(look_.color.y),
                  light(look_.color.z), static_cast<float>(look_.alpha));
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_FALSE);
    gl_.BindVertexArray(vertices_.name());
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(threads_.segments().size()));
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_DEPTH_TEST);
}

}  // namespace orbweaver::view
