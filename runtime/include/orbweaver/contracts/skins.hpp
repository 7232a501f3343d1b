#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A corner of a skin. It goes with two bones, as their weighted mean moves it (linear-blend skinning).
struct SkinVertex {
    std::array<float, 3> position;       ///< m, in the rest pose, which has a frame of its own
    std::array<float, 3> normal;         ///< unit, outward, likewise
    std::array<float, 3> color;          ///< sRGB shade in full light, [0, 1]
    float gloss = 0;                     ///< from dull and hairy, 0, to polished, 1
    std::array<std::uint32_t, 2> bones;  ///< of which each weighs
    std::array<float, 2> weights;        ///< as much; they sum to 1
};

/// A bone as something round that keeps the sky's light from what is near it; radius 0: it does not.
struct SkinRod {
    Vec3 a, b;  ///< m, in the rest pose
    double radius = 0;
};

/// What all creatures of a kind share: triangles, counter-clockwise seen from outside, of closed parts; and
/// bones.
struct SkinMesh {
    std::span<const SkinVertex> vertices;
    std::span<const std::array<std::uint32_t, 3>> triangles;
    std::span<const SkinRod> rods;  ///< one for each bone
};

/// Where a bone has gone: what was at p in the rest pose is at `at` + p.x `x` + p.y `y` + p.z `z` (m, world).
/// A turn and a shift: x, y and z are unit vectors at right angles.
struct SkinMove {
    Vec3 x, y, z, at;
};

/// Bodies with a skin, all of one kind, to be seen.
class Skins {
public:
    static constexpr const char* kContract = "skins/1";

    /// Made when it is first asked for: who draws nothing pays nothing. Does not change.
    virtual SkinMesh mesh() = 0;
    /// Of each creature, as it is now, a move for each of mesh().rods.
    virtual std::span<const SkinMove> moves() = 0;

protected:
    ~Skins() = default;
};

}  // namespace orbweaver
