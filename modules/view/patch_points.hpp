#pragma once

#include <span>
#include <vector>

#include "gl.hpp"
#include "orbweaver/contracts/patches.hpp"
#include "texel_buffer.hpp"

namespace orbweaver::view {

/// Where the control points of a provider's bodies are now, as shaders read it: a texture of one texel a point.
class PatchPoints {
public:
    PatchPoints(const Gl& gl, Patches& patches);
    /// Asks the provider anew. Throws Fault(limit) when the driver takes no texture of so many.
    void update();
    /// Makes it the texture of GL_TEXTURE0 + unit.
    void bind(GLenum unit) const { buffer_.bind(unit); }

    /// What has points now; no bodies when there are too few of them for a patch.
    const PatchLayout& layout() const noexcept { return layout_; }
    /// m, as the provider told them last; no longer valid once it has moved on.
    std::span<const Vec3> latest() const noexcept { return latest_; }
    const Vec3& origin() const noexcept { return origin_; }
    std::size_t memory_bytes() const noexcept { return 2 * texels_.capacity() * sizeof(float); }

private:
    const Gl& gl_;
    Patches& patches_;
    TexelBuffer buffer_;
    PatchLayout layout_;
    std::span<const Vec3> latest_;
    std::vector<float> texels_;
    Vec3 origin_;  // m, so that floats keep their digits far from the scene's origin
};

}  // namespace orbweaver::view
