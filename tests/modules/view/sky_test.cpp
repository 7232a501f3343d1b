#include "sky.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace orbweaver;
using namespace orbweaver::view;
using picture::LinearPicture;

namespace {

/// An equirectangular picture whose color is its own direction, (d + 1) / 2.
LinearPicture compass(int width) {
    LinearPicture p{width, width / 2, false, {}};
    for (int y = 0; y < p.height; ++y) {
        for (int x = 0; x < p.width; ++x) {
            const double azimuth = ((x + 0.5) / p.width - 0.5) * 2 * std::numbers::pi;
            const double elevation = (0.5 - (y + 0.5) / p.height) * std::numbers::pi;
            const Vec3 d{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                         -std::cos(elevation) * std::cos(azimuth)};
            for (const double c : {d.x, d.y, d.z}) p.rgb.push_back(static_cast<float>((c + 1) / 2));
        }
    }
    return p;
}

double error(const float* color, const Vec3& direction) {
    const Vec3 d = direction / norm(direction);
    return std::max({std::abs(color[0] - (d.x + 1) / 2), std::abs(color[1] - (d.y + 1) / 2),
                     std::abs(color[2] - (d.z + 1) / 2)});
}

}  // namespace

TEST_CASE("the middle of the picture is -z, three quarters of its width +x, its first row +y", "[unit]") {
    LinearPicture p{8, 4, false, std::vector<float>(96, 0.0F)};
    const auto mark = [&](int x, int y, float value) {
        p.rgb[static_cast<std::size_t>(3 * (8 * y + x))] = value;
    };
    for (const int x : {3, 4})
        for (const int y : {1, 2}) mark(x, y, 0.25F);
    for (const int x : {5, 6})
        for (const int y : {1, 2}) mark(x, y, 0.5F);
    for (int x = 0; x < 8; ++x) mark(x, 0, 0.75F);
    CHECK(sample_equirectangular(p, {0, 0, -1})[0] == Approx(0.25));
    CHECK(sample_equirectangular(p, {1, 0, 0})[0] == Approx(0.5));
    CHECK(sample_equirectangular(p, {0, 1, 0})[0] == Approx(0.75));
    CHECK(sample_equirectangular(p, {0, -1, 0})[0] == Approx(0.0));
}

TEST_CASE("each direction reaches its face, everywhere on the cube and across its edges", "[unit]") {
    const auto sky = cube_from_equirectangular(compass(512), 1);
    const auto n = static_cast<std::size_t>(sky.size);
    REQUIRE(sky.size == 170);
    double worst = 0;
    for (std::size_t f = 0; f < kFaces; ++f) {
        for (std::size_t i = 0; i < n * n; ++i) {
            const double s = (static_cast<double>(i % n) + 0.5) / sky.size;
            const double t = (static_cast<double>(i / n) + 0.5) / sky.size;
            worst = std::max(worst, error(&sky.faces[f][3 * i], face_direction(static_cast<Face>(f), s, t)));
        }
    }
    CHECK(worst < 0.007);  // half a pixel of the picture, pi / 512, at the poles, where it is clamped
}

TEST_CASE("faces are upright seen from inside; top and bottom join the front", "[unit]") {
    CHECK(face_direction(Face::front, 0.5, 0.5) == Vec3{0, 0, -1});
    CHECK(face_direction(Face::front, 1, 0.5) == face_direction(Face::right, 0, 0.5));
    CHECK(face_direction(Face::right, 1, 0.5) == face_direction(Face::back, 0, 0.5));
    CHECK(face_direction(Face::back, 1, 0.5) == face_direction(Face::left, 0, 0.5));
    CHECK(face_direction(Face::left, 1, 0.5) == face_direction(Face::front, 0, 0.5));
    CHECK(face_direction(Face::top, 0.3, 1) == face_direction(Face::front, 0.3, 0));
    CHECK(face_direction(Face::bottom, 0.3, 0) == face_direction(Face::front, 0.3, 1));
}

TEST_CASE("the seam behind the viewer does not show", "[unit]") {
    const auto p = compass(64);
    const auto left = sample_equirectangular(p, {-1e-9, 0.1, 1});
    const auto right = sample_equirectangular(p, {1e-9, 0.1, 1});
    for (std::size_t c = 0; c < 3; ++c) CHECK(left[c] == Approx(right[c]).margin(1e-6));
}

TEST_CASE("only a sky of high dynamic range is tone-mapped, and no light is too bright for it", "[unit]") {
    CHECK(shown_light(0.5F, 1, false) == 0.5F);
    CHECK(shown_light(0.5F, 4, false) == 1);
    CHECK(shown_light(1, 1, true) == Approx((2.51 + 0.03) / (2.43 + 0.59 + 0.14)));
    CHECK(shown_light(0, 1, true) == 0);
    for (const float light : {1e3F, 1e20F, 3e38F})
        CHECK(shown_light(light, 1000, true) == Approx(1).epsilon(0.03));
}

TEST_CASE("six faces are taken as they are", "[unit]") {
    std::array<LinearPicture, kFaces> pictures;
    for (std::size_t f = 0; f < kFaces; ++f)
        pictures[f] = {2, 2, false, std::vector<float>(12, static_cast<float>(f) / 10)};
    const auto sky = cube_from_faces(pictures, 1);
    CHECK(sky.size == 2);
    for (std::size_t f = 0; f < kFaces; ++f) CHECK(sky.faces[f] == pictures[f].rgb);
}

TEST_CASE("the plain sky is darker than any thread", "[unit]") {
    const auto sky = plain_sky();
    for (const auto& face : sky.faces)
        for (const float c : face) CHECK((c >= 0 && c < 0.2F));
}
