#pragma once

#include <array>

#include "sky.hpp"

namespace orbweaver::view {

/// The mean light of each face of a sky, linear: what comes from there, wherever exactly.
using SkyLight = std::array<std::array<float, 3>, kFaces>;
SkyLight sky_light(const CubeSky& sky);

/// The brightest part of a sky, as if all its light came from one place: its mean direction and mean light,
/// each pixel weighed by the fourth power of its light and by the solid angle that it fills.
struct KeyLight {
    Vec3 direction{0, 1, 0};  ///< unit, towards it
    std::array<float, 3> light{};
};
KeyLight key_light(const CubeSky& sky);

}  // namespace orbweaver::view
