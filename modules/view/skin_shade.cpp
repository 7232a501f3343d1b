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
    : pass_(gl, (std::string(kMovedSource) + kRods).c_str(), Joints::loose, key),
      rods_(gl),
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
    rods_.upload(texels, GL_STATIC_DRAW, 1);
}

void SkinShade::draw(const SkinMoves& moves, GLuint depths, const Camera& camera, int width, int height) const {
    if (moves.creatures() == 0) return;
    moves.bind(0);
    rods_.bind(1);
    pass_.draw({bones_ * moves.creatures(), bones_, moves.origin(), cast_}, depths, camera, width, height);
}

}  // namespace orbweaver::view
