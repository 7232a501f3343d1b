#include "skin_shade.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace orbweaver::view {
namespace {

constexpr const char* kRods = R"(
uniform samplerBuffer rods;
void find_rod(int i, out vec4 from, out vec3 to) {
    int creature = i / bones, bone = i % bones;
    vec4 a = texelFetch(rods, 2 * bone), b = texelFetch(rods, 2 * bone + 1);
    from = vec4(moved(creature, bone, vec4(a.xyz, 1)), a.w);
    to = moved(creature, bone, vec4(b.xyz, 1));
}
)";

}  // namespace

SkinShade::SkinShade(const Gl& gl, const SkinMesh& mesh, const KeyLight& key)
    : gl_(gl),
      pass_(gl, (std::string(kMovedSource) + kRods).c_str(), Joints::loose, key),
      rod_buffer_(gl, ObjectKind::buffer),
      rod_texture_(gl, ObjectKind::texture),
      bones_(static_cast<GLint>(mesh.rods.size())) {
    constexpr double kThrown = 1.2;  // of the longest way from the first rod to another's end
    std::vector<float> texels;
    double extent = 0;
    for (const SkinRod& rod : mesh.rods) extent = std::max(extent, distance(rod.b, mesh.rods.front().a));
    cast_ = kThrown * extent;
    for (const SkinRod& rod : mesh.rods)
        for (const double number : {rod.a.x, rod.a.y, rod.a.z, rod.radius, rod.b.x, rod.b.y, rod.b.z, 0.0})
            texels.push_back(static_cast<float>(number));
    memory_bytes_ = texels.size() * sizeof(float);
    gl.BindBuffer(GL_TEXTURE_BUFFER, rod_buffer_.name());
    gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(memory_bytes_), texels.data(), GL_STATIC_DRAW);
    gl.BindTexture(GL_TEXTURE_BUFFER, rod_texture_.name());
    gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, rod_buffer_.name());
}

void SkinShade::draw(const SkinMoves& moves, GLuint depths, const Camera& camera, int width, int height) const {
    if (moves.creatures() == 0) return;
    moves.bind(0);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_BUFFER, rod_texture_.name());
    pass_.draw({bones_ * moves.creatures(), bones_, moves.origin(), cast_}, depths, camera, width, height);
}

}  // namespace orbweaver::view
