#pragma once

#include <vector>

#include "camera.hpp"
#include "gl.hpp"
#include "orbweaver/contracts/sketch.hpp"

namespace orbweaver::view {

/// Draws lines of three pixels' width over all that is there, hidden or not.
class SketchPass {
public:
    /// Reads `sketch` for as long as it lives.
    SketchPass(const Gl& gl, Sketch& sketch);
    /// Blends over the bound framebuffer, width x height pixels, which must hold sRGB with conversion enabled.
    void draw(const Camera& camera, int width, int height);
    std::size_t memory_bytes() const noexcept { return 2 * numbers_.capacity() * sizeof(float); }

private:
    const Gl& gl_;
    Sketch& sketch_;
    Object program_;
    Object vertices_;
    Object line_buffer_;
    std::vector<float> numbers_;  // of each line: a, b, linear color
};

}  // namespace orbweaver::view
