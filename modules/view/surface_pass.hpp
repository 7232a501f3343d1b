#pragma once

#include <array>
#include <vector>

#include "camera.hpp"
#include "gl.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// How a surface looks.
struct SurfaceLook {
    Vec3 color;        ///< sRGB shade in full light, [0, 1]
    double edges = 0;  ///< opacity of the lines between its polygons, [0, 1]
};

/// A code for each corner of each face: vertex * 16 + 8 where nobody can climb it, as on glass + a bit for each
/// edge of the face (from corner e to corner e + 1) that its polygon ends at. Edges within a polygon are not of
/// the source.
std::vector<std::uint32_t> corner_codes(const Surface& surface);

/// Draws a surface, which does not move, each face in one shade. A face with unit normal n towards the viewer
/// is lit by sum n_i^2 light(sign(n_i) e_i), the sky's six directions weighed as McTaggart does (Half-Life 2 /
/// Valve Source Shading, GDC 2004).
class SurfacePass {
public:
    /// Reads `surface` for as long as it lives.
    SurfacePass(const Gl& gl, const Surface& surface, const SurfaceLook& look, const SkyLight& light);
    /// Draws on the bound framebuffer, which must hold sRGB with conversion enabled, and depths.
    void draw(const Camera& camera, int width, int height) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    const Gl& gl_;
    SurfaceLook look_;
    SkyLight light_;
    Object program_;
    Object vertices_;
    Object corner_buffer_;
    Object point_buffer_;
    Object point_texture_;
    Vec3 origin_;  // m, so that floats keep their digits far from the scene's origin
    GLsizei corners_ = 0;
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
