#include "sky_pass.hpp"

#include "shader.hpp"

namespace orbweaver::view {
namespace {

// One triangle that covers the picture.
constexpr const char* kVertex = R"(#version 330 core
uniform vec3 right;
uniform vec3 up;
uniform vec3 forward;
out vec3 direction;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
    direction = forward + corner.x * right + corner.y * up;
    gl_Position = vec4(corner, 0, 1);
}
)";

// GL's cube maps are left-handed, seen from inside: z turns over.
constexpr const char* kFragment = R"(#version 330 core
uniform samplerCube sky;
in vec3 direction;
out vec4 color;
void main() { color = vec4(texture(sky, vec3(direction.xy, -direction.z)).rgb, 1); }
)";

void set_vector(const Gl& gl, const Object& program, const char* name, const Vec3& v) {
    gl.Uniform3f(gl.GetUniformLocation(program.name(), name), static_cast<float>(v.x), static_cast<float>(v.y),
                 static_cast<float>(v.z));
}

}  // namespace

SkyPass::SkyPass(const Gl& gl, const CubeSky& sky)
    : gl_(gl),
      program_(make_program(gl, "sky", kVertex, kFragment)),
      cube_(gl, ObjectKind::texture),
      vertices_(gl, ObjectKind::vertex_array) {
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t f = 0; f < kFaces; ++f) {
        gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(f), 0, GL_RGB16F, sky.size, sky.size,
                      0, GL_RGB, GL_FLOAT, sky.faces[f].data());
        memory_bytes_ += sky.faces[f].size() * 2;
    }
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void SkyPass::draw(const Camera& camera, double aspect) const {
    const auto a = axes(camera);
    const double half = half_height(camera);
    gl_.Disable(GL_BLEND);
    gl_.UseProgram(program_.name());
    set_vector(gl_, program_, "right", a.right * (half * aspect));
    set_vector(gl_, program_, "up", a.up * half);
    set_vector(gl_, program_, "forward", a.forward);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, cube_.name());
    gl_.BindVertexArray(vertices_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace orbweaver::view
