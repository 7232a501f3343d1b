#include "body_light.hpp"

#include <string>

namespace orbweaver::view {

const char* const kBodyLightSource = R"(
uniform vec3 light[6];  // from +x, -x, +y, -y, -z, +z
uniform vec3 key_direction;
uniform vec3 key_light;

vec3 sky(vec3 n) {
    vec3 part = n * n;
    return part.x * (n.x > 0 ? light[0] : light[1]) + part.y * (n.y > 0 ? light[2] : light[3]) +
           part.z * (n.z < 0 ? light[4] : light[5]);
}
vec3 lit_body(vec3 paint, float gloss, vec3 n, vec3 v) {
    vec3 h = normalize(v + key_direction);
    float dull = 1 - gloss, facing = max(dot(n, v), 0), to_key = dot(n, key_direction);
    vec3 lit = 0.9 * sky(n) + 1.5 * key_light * max((to_key + 0.2) / 1.2, 0);
    vec3 sheen = dull * pow(1 - facing, 3) * (0.25 * paint + 0.06) * (sky(n) + 0.5 * key_light * max(to_key, 0));
    float narrow = mix(10, 160, gloss * gloss);
    vec3 shine = key_light * pow(max(dot(n, h), 0), narrow) * mix(0.04, 1.2, gloss * gloss) * step(0, to_key);
    vec3 mirror = sky(reflect(-v, n)) * gloss * gloss * (0.05 + 0.6 * pow(1 - facing, 5));
    return paint * lit + sheen + shine + mirror;
}
)";

void use_body_program(const Gl& gl, const Object& program, const Vec3& origin, const BodyPicture& picture,
                      const SkyLight& light, const KeyLight& key) {
    const Camera& camera = picture.camera;
    const Camera local{camera.position - origin, camera.target - origin, camera.fov_degrees};
    const auto [near, far] = clip_depths(camera);
    const auto matrix = view_projection(local, static_cast<double>(picture.width) / picture.height, near, far);
    const auto uniform = [&](const std::string& name) {
        return gl.GetUniformLocation(program.name(), name.c_str());
    };
    gl.UseProgram(program.name());
    gl.UniformMatrix4fv(uniform("view_projection"), 1, GL_FALSE, matrix.data());
    gl.Uniform3f(uniform("eye"), static_cast<float>(local.position.x), static_cast<float>(local.position.y),
                 static_cast<float>(local.position.z));
    for (std::size_t f = 0; f < kFaces; ++f)
        gl.Uniform3f(uniform("light[" + std::to_string(f) + "]"), light[f][0], light[f][1], light[f][2]);
    gl.Uniform3f(uniform("key_direction"), static_cast<float>(key.direction.x),
                 static_cast<float>(key.direction.y), static_cast<float>(key.direction.z));
    gl.Uniform3f(uniform("key_light"), key.light[0], key.light[1], key.light[2]);
}

void draw_bodies(const Gl& gl, GLsizei corners, GLsizei bodies) {
    gl.Disable(GL_BLEND);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_BACK);
    gl.DrawElementsInstanced(GL_TRIANGLES, corners, GL_UNSIGNED_INT, nullptr, bodies);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_DEPTH_TEST);
}

}  // namespace orbweaver::view
