#pragma once

#include "camera.hpp"
#include "patch_points.hpp"
#include "sky_light.hpp"

namespace orbweaver::view {

/// Draws bodies whose skin is uniform bicubic B-spline patches, all of a kind at once: a grid of (along,
/// around) that is the same for every tube, put by the vertex shader where the sixteen control points around a
/// patch say. The map wraps around each tube once: its first column where the first point of the rings is, its
/// first row at the tail. Its heights turn the normal, as slopes of the skin would; the light is that of all
/// bodies.
class PatchPass {
public:
    /// Asks for the layout and the map. Throws Fault(limit) when the map is larger than the driver takes,
    /// Fault(internal) when it is not as large as it says.
    PatchPass(const Gl& gl, Patches& patches, const SkyLight& light, const KeyLight& key);
    /// Draws on the bound framebuffer, which must hold sRGB with conversion enabled, and depths.
    void draw(const PatchPoints& points, const Camera& camera, int width, int height) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    void upload_grid(const PatchLayout& layout);
    void upload_map(const PatchMap& map);

    const Gl& gl_;
    SkyLight light_;
    KeyLight key_;
    Object program_;
    Object vertices_;  // none but their numbers
    Object triangle_buffer_;
    Object map_;
    float relief_ = 0;  // m
    float gloss_ = 0;
    GLint steps_around_ = 0;  // of a patch
    GLsizei corners_ = 0;
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
