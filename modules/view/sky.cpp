#include "sky.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbweaver::view {
namespace {

constexpr int kSmallestFace = 16;
constexpr int kLargestFace = 2048;
constexpr int kPlainFace = 64;
constexpr float kBrightest = 1e4F;  // of a sun's disk: more would overflow the tone curve and changes nothing

template <class Light>
CubeSky fill(int size, Light&& light) {
    CubeSky sky;
    sky.size = size;
    const auto n = static_cast<std::size_t>(size);
    for (std::size_t f = 0; f < kFaces; ++f) {
        sky.faces[f].resize(3 * n * n);
        for (std::size_t row = 0; row < n; ++row) {
            for (std::size_t column = 0; column < n; ++column) {
                const double s = (static_cast<double>(column) + 0.5) / size;
                const double t = (static_cast<double>(row) + 0.5) / size;
                const auto rgb = light(face_direction(static_cast<Face>(f), s, t));
                std::copy(rgb.begin(), rgb.end(), &sky.faces[f][3 * (row * n + column)]);
            }
        }
    }
    return sky;
}

}  // namespace

Vec3 face_direction(Face face, double s, double t) noexcept {
    const double right = 2 * s - 1;
    const double up = 1 - 2 * t;
    switch (face) {
        case Face::right:
            return {1, up, right};
        case Face::left:
            return {-1, up, -right};
        case Face::top:
            return {right, 1, up};
        case Face::bottom:
            return {right, -1, -up};
        case Face::front:
            return {right, up, -1};
        case Face::back:
            return {-right, up, 1};
    }
    return {};
}

std::array<float, 3> sample_equirectangular(const picture::LinearPicture& picture,
                                            const Vec3& direction) noexcept {
    const double azimuth = std::atan2(direction.x, -direction.z) / (2 * std::numbers::pi);
    const double elevation = std::asin(direction.y / norm(direction)) / std::numbers::pi;
    const double x = (0.5 + azimuth) * picture.width - 0.5;
    const double y = std::clamp((0.5 - elevation) * picture.height - 0.5, 0.0, picture.height - 1.0);
    const double column = std::floor(x);
    const int x0 = (static_cast<int>(column) + picture.width) % picture.width;
    const int x1 = (x0 + 1) % picture.width;
    const int y0 = static_cast<int>(y);
    const int y1 = std::min(y0 + 1, picture.height - 1);
    const auto across = static_cast<float>(x - column);
    const auto down = static_cast<float>(y - y0);
    std::array<float, 3> light{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float above = std::lerp(picture.pixel(x0, y0)[c], picture.pixel(x1, y0)[c], across);
        const float below = std::lerp(picture.pixel(x0, y1)[c], picture.pixel(x1, y1)[c], across);
        light[c] = std::lerp(above, below, down);
    }
    return light;
}

float shown_light(float light, double exposure, bool high_dynamic_range) noexcept {
    const float x = std::clamp(light * static_cast<float>(exposure), 0.0F, kBrightest);
    const float y = high_dynamic_range ? x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F) : x;
    return std::min(y, 1.0F);
}

CubeSky cube_from_equirectangular(const picture::LinearPicture& picture, double exposure) {
    // A face's middle then has at least the picture's own density of pixels: width / (2 pi) per radian.
    const int size = std::clamp(picture.width / 3, kSmallestFace, kLargestFace);
    return fill(size, [&](const Vec3& direction) {
        auto light = sample_equirectangular(picture, direction);
        for (float& c : light) c = shown_light(c, exposure, picture.high_dynamic_range);
        return light;
    });
}

CubeSky cube_from_faces(const std::array<picture::LinearPicture, kFaces>& pictures, double exposure) {
    CubeSky sky;
    sky.size = pictures.front().width;
    for (std::size_t f = 0; f < kFaces; ++f) {
        sky.faces[f].resize(pictures[f].rgb.size());
        std::transform(pictures[f].rgb.begin(), pictures[f].rgb.end(), sky.faces[f].begin(), [&](float light) {
            return shown_light(light, exposure, pictures[f].high_dynamic_range);
        });
    }
    return sky;
}

CubeSky plain_sky() {
    constexpr std::array<float, 3> kGround = {0.010F, 0.013F, 0.012F};
    constexpr std::array<float, 3> kHorizon = {0.075F, 0.100F, 0.115F};
    constexpr std::array<float, 3> kZenith = {0.014F, 0.024F, 0.045F};
    return fill(kPlainFace, [&](const Vec3& direction) {
        const auto height = static_cast<float>(direction.y / norm(direction));
        const auto& end = height > 0 ? kZenith : kGround;
        const float t = std::sqrt(std::abs(height));
        std::array<float, 3> light{};
        for (std::size_t c = 0; c < 3; ++c) light[c] = std::lerp(kHorizon[c], end[c], t);
        return light;
    });
}

}  // namespace orbweaver::view
