#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "orbweaver/vec3.hpp"
#include "picture/picture.hpp"

namespace orbweaver::view {

/// The six directions of a cube map, in GL's order of layers. A face is upright as seen from inside;
/// top's lower edge and bottom's upper edge join front.
enum class Face : std::size_t { right, left, top, bottom, front, back };
inline constexpr std::size_t kFaces = 6;
inline constexpr std::array<const char*, kFaces> kFaceNames = {"right",  "left",  "top",
                                                               "bottom", "front", "back"};

/// A sky on six square faces of `size` x `size` pixels: linear light in [0, 1], 3 floats a pixel, rows
/// from the top; ready to be shown.
struct CubeSky {
    int size = 0;
    std::array<std::vector<float>, kFaces> faces;
};

/// The direction (not of unit length; its largest component is 1) of a place on a face: s to the right and
/// t down, both in [0, 1]. front is -z, right is +x, top is +y.
Vec3 face_direction(Face face, double s, double t) noexcept;

/// The light of an equirectangular picture in a direction, bilinear: azimuth 0 (-z) in the middle column, +x at
/// three quarters of the width, +y on the first row.
std::array<float, 3> sample_equirectangular(const picture::LinearPicture& picture,
                                            const Vec3& direction) noexcept;

/// Light as it is shown: times `exposure`, and if `high_dynamic_range` through a filmic curve,
/// x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) (Narkowicz 2015); otherwise cut at 1.
float shown_light(float light, double exposure, bool high_dynamic_range) noexcept;

/// An equirectangular picture on six faces.
CubeSky cube_from_equirectangular(const picture::LinearPicture& picture, double exposure);
/// Six square pictures of one size, in the order of Face.
CubeSky cube_from_faces(const std::array<picture::LinearPicture, kFaces>& pictures, double exposure);
/// What is shown when a scene names no sky: a dusk gradient, dark enough for pale threads.
CubeSky plain_sky();

}  // namespace orbweaver::view
