#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// Control points of tubes, `bodies` of them, each of `rings` rings from tail to head with `sides` points around.
struct PatchLayout {
    std::size_t bodies = 0;
    std::size_t rings = 0;  ///< at least 4
    std::size_t sides = 0;  ///< at least 3
};

/// What is wrapped around every tube: `columns` texels once around it, `rows` of them from tail to head.
struct PatchMap {
    std::uint32_t columns = 0, rows = 0;
    /// Four bytes a texel, row by row: sRGB shade in full light, and height.
    std::span<const std::uint8_t> texels;
    double relief = 0;  ///< m, between heights 0 and 255
    double gloss = 0;   ///< from dull, 0, to polished, 1
};

/// Bodies that bend and bulge, each with a skin of uniform bicubic B-spline patches: rings - 3 of them along the
/// tube, `sides` around it, where it is closed. Seen from outside, points go counter-clockwise around a ring that
/// is looked at from the head.
class Patches {
public:
    static constexpr const char* kContract = "patches/1";

    /// Neither changes. The map is made when it is first asked for: who draws nothing pays nothing.
    virtual PatchLayout layout() const noexcept = 0;
    virtual PatchMap map() = 0;
    /// m, as they are now: body after body, ring after ring. Asked for once a picture.
    virtual std::span<const Vec3> points() = 0;

protected:
    ~Patches() = default;
};

}  // namespace orbweaver
