#include "sky_light.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

/// Each face of one light: 0.1 to the right, 0.2 to the left, 0.3 above ...
CubeSky six_lights(std::size_t size) {
    CubeSky sky;
    sky.size = static_cast<int>(size);
    for (std::size_t f = 0; f < kFaces; ++f)
        sky.faces[f].assign(3 * size * size, 0.1F * static_cast<float>(f + 1));
    return sky;
}

void darken(CubeSky& sky) {
    for (auto& face : sky.faces) std::fill(face.begin(), face.end(), 0.0F);
}

}  // namespace

TEST_CASE("the light of a sky is the mean of each face", "[unit]") {
    CubeSky sky = six_lights(2);
    sky.faces[2] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    const SkyLight light = sky_light(sky);
    CHECK(light[0][1] == Approx(0.1));
    CHECK(light[2] == std::array<float, 3>{0.5F, 0.5F, 1});
}

TEST_CASE("the key light comes from the only pixel that shines, in its colour", "[unit]") {
    CubeSky sky = six_lights(16);
    darken(sky);
    float* pixel = &sky.faces[static_cast<std::size_t>(Face::right)][std::size_t{3} * (2 * 16 + 12)];
    pixel[0] = 0.9F;
    pixel[1] = 0.6F;
    const KeyLight key = key_light(sky);
    const Vec3 way = face_direction(Face::right, 12.5 / 16, 2.5 / 16);
    CHECK(distance(key.direction, way / norm(way)) < 1e-12);
    CHECK(key.light[0] == Approx(0.9));
    CHECK(key.light[1] == Approx(0.6));
    CHECK(key.light[2] == 0);
}

TEST_CASE("an even sky's light comes from above, a black one's too, without strength", "[unit]") {
    CubeSky sky = six_lights(8);
    for (auto& face : sky.faces) std::fill(face.begin(), face.end(), 0.5F);
    CHECK(key_light(sky).direction == Vec3{0, 1, 0});
    CHECK(key_light(sky).light[0] == Approx(0.5));
    darken(sky);
    CHECK(key_light(sky).direction == Vec3{0, 1, 0});
    CHECK(key_light(sky).light[0] == 0);
}
