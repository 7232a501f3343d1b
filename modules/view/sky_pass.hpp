#pragma once

#include "camera.hpp"
#include "gl.hpp"
#include "sky.hpp"

namespace orbweaver::view {

/// Draws the sky over the whole of the bound framebuffer.
class SkyPass {
public:
    SkyPass(const Gl& gl, const CubeSky& sky);
    void draw(const Camera& camera, double aspect) const;
    std::size_t memory_bytes() const noexcept { return memory_bytes_; }

private:
    const Gl& gl_;
    Object program_;
    Object cube_;
    Object vertices_;
    std::size_t memory_bytes_ = 0;
};

}  // namespace orbweaver::view
