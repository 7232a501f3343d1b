#include "sky_pass.hpp"

#include <cmath>

#include "frame_target.hpp"
#include "offscreen.hpp"
#include "picture/color.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

/// A sky whose color is its own direction, (d + 1) / 2.
CubeSky compass() {
    CubeSky sky;
    sky.size = 64;
    for (std::size_t f = 0; f < kFaces; ++f) {
        for (int i = 0; i < 64 * 64; ++i) {
            const Vec3 d = face_direction(static_cast<Face>(f), (i % 64 + 0.5) / 64, (i / 64 + 0.5) / 64);
            const Vec3 unit = d / norm(d);
            for (const double c : {unit.x, unit.y, unit.z})
                sky.faces[f].push_back(static_cast<float>((c + 1) / 2));
        }
    }
    return sky;
}

}  // namespace

TEST_CASE("the sky stands where its directions say, whichever way the camera looks", "[image]") {
    constexpr int kSize = 33;
    test::Offscreen canvas(kSize, kSize);
    FrameTarget target(canvas.gl, kSize, kSize);
    const SkyPass sky(canvas.gl, compass());
    const auto light = picture::linear_from_byte();
    for (const Vec3& at : {Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0},
                           Vec3{0, -1, 0}, Vec3{0.7, 0.4, -0.6}}) {
        const Camera camera{{0, 0, 0}, at, 80};
        const auto a = axes(camera);
        const double half = half_height(camera);
        target.bind();
        sky.draw(camera, 1);
        std::vector<std::uint8_t> rgb;
        target.read(rgb);
        double worst = 0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const Vec3 d = a.forward + a.right * (half * (2 * (x + 0.5) / kSize - 1)) +
                               a.up * (half * (1 - 2 * (y + 0.5) / kSize));
                const Vec3 unit = d / norm(d);
                const std::uint8_t* pixel = &rgb[static_cast<std::size_t>(3 * (y * kSize + x))];
                worst = std::max({worst, std::abs(light[pixel[0]] - (unit.x + 1) / 2),
                                  std::abs(light[pixel[1]] - (unit.y + 1) / 2),
                                  std::abs(light[pixel[2]] - (unit.z + 1) / 2)});
            }
        }
        INFO("towards " << at.x << ' ' << at.y << ' ' << at.z);
        CHECK(worst < 0.02);  // two shades of 8-bit sRGB where they are farthest apart, and a face's pixels
    }
}
