#pragma once

#include <vector>

#include "patch_points.hpp"
#include "shade_pass.hpp"

namespace orbweaver::view {

/// A piece of a tube, as something round.
struct TubeRod {
    Vec3 from, to;      ///< m
    double radius = 0;  ///< m, its mean; 0: it has no length or no width
};
/// The tubes as chains of rods along the middles of their rings, each of as many, at most 24: from tail to
/// head, body after body. `points` has all of the layout's.
std::vector<TubeRod> tube_rods(const PatchLayout& layout, std::span<const Vec3> points);

/// The shade of bodies of patches: of chains of rods.
class PatchShade {
public:
    PatchShade(const Gl& gl, const KeyLight& key);
    /// As ShadePass::draw.
    void draw(const PatchPoints& points, GLuint depths, const Camera& camera, int width, int height);
    std::size_t memory_bytes() const noexcept { return 2 * texels_.capacity() * sizeof(float); }

private:
    void upload(const std::vector<TubeRod>& rods, const Vec3& origin);

    ShadePass pass_;
    TexelBuffer rods_;
    std::vector<float> texels_;
};

}  // namespace orbweaver::view
