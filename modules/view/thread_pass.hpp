#pragma once

#include <cstdint>
#include <vector>

#include "camera.hpp"
#include "gl.hpp"
#include "orbweaver/contracts/threads.hpp"

namespace orbweaver::view {

/// How threads look.
struct ThreadLook {
    double width = 4e-4;  ///< m
    Vec3 color;           ///< sRGB shade, [0, 1]
    double alpha = 1;     ///< opacity where a thread covers a pixel wholly
};

/// Draws the threads of one provider: each segment as a quad that faces the camera, expanded in the vertex
/// shader. With w the projected width in pixels and d a pixel center's distance from the thread's axis,
/// opacity = alpha min(w, 1) clamp((max(w, 1) + 1)/2 - |d|, 0, 1), whose sum across the thread is alpha w.
class ThreadPass {
public:
    ThreadPass(const Gl& gl, const Threads& threads, const ThreadLook& look);
    /// Blends over the bound framebuffer, width x height pixels, which must hold sRGB with conversion enabled.
    /// What lies behind its depths, if it holds some, is hidden; they stay as they are.
    void draw(const Camera& camera, int width, int height);
    std::size_t memory_bytes() const noexcept;

private:
    void upload_segments();
    void upload_points();

    const Gl& gl_;
    const Threads& threads_;
    ThreadLook look_;
    Object program_;
    Object vertices_;
    Object segment_buffer_;
    Object point_buffer_;
    Object point_texture_;
    std::vector<float> points_;  // x y z 1 each, relative to origin_
    Vec3 origin_;                // m, so that floats keep their digits far from the scene's origin
    std::uint64_t revision_ = 0;
    bool uploaded_ = false;
};

}  // namespace orbweaver::view
