#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbweaver::view {
namespace {

constexpr double kMargin = 1.06;        // of the framed points' extent
constexpr double kSteepest = 1.5;       // rad above the horizon that an orbit reaches, short of the pole
constexpr double kNearestFrame = 1e-3;  // m, when there is nothing to frame

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Vec3 normalized(const Vec3& v) { return v / norm(v); }

}  // namespace

CameraAxes axes(const Camera& camera) {
    CameraAxes a;
    a.forward = normalized(camera.target - camera.position);
    Vec3 right = cross(a.forward, {0, 1, 0});
    if (norm(right) < 1e-9) right = {1, 0, 0};  // looking straight up or down: the scene's x stays to the right
    a.right = normalized(right);
    a.up = cross(a.right, a.forward);
    return a;
}

double half_height(const Camera& camera) { return std::tan(radians(camera.fov_degrees) / 2); }

Landing project(const Camera& camera, const Vec3& point, int width, int height) {
    const auto a = axes(camera);
    const Vec3 p = point - camera.position;
    const double depth = dot(p, a.forward);
    const double focal = height / (2 * half_height(camera));
    return {width / 2.0 + focal * dot(p, a.right) / depth, height / 2.0 - focal * dot(p, a.up) / depth, depth};
}

std::array<float, 16> view_projection(const Camera& camera, double aspect, double near, double far) {
    const auto a = axes(camera);
    const double y_scale = 1 / half_height(camera);
    const double x_scale = y_scale / aspect;
    const double z_scale = (far + near) / (far - near);
    const double z_shift = -2 * far * near / (far - near);
    const Vec3 rows[4] = {a.right * x_scale, a.up * y_scale, a.forward * z_scale, a.forward};
    std::array<float, 16> m{};
    for (std::size_t r = 0; r < 4; ++r) {
        m[r] = static_cast<float>(rows[r].x);
        m[4 + r] = static_cast<float>(rows[r].y);
        m[8 + r] = static_cast<float>(rows[r].z);
        m[12 + r] = static_cast<float>(-dot(rows[r], camera.position) + (r == 2 ? z_shift : 0));
    }
    return m;
}

ClipDepths clip_depths(const Camera& camera) {
    const double away = distance(camera.position, camera.target);
    return {1e-3 * away, 1e3 * away};
}

Camera orbit(const Camera& camera, double x, double y) {
    const Vec3 arm = camera.position - camera.target;
    const double length = norm(arm);
    const double azimuth = std::atan2(arm.x, arm.z) - x * std::numbers::pi;
    const double height = std::asin(std::clamp(arm.y / length, -1.0, 1.0)) - y * std::numbers::pi;
    const double elevation = std::clamp(height, -kSteepest, kSteepest);
    Camera turned = camera;
    turned.position =
        camera.target + length * Vec3{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                      std::cos(elevation) * std::cos(azimuth)};
    return turned;
}

Camera zoom(const Camera& camera, double notches) {
    Camera moved = camera;
    moved.position = camera.target + (camera.position - camera.target) * std::pow(0.9, notches);
    return moved;
}

Camera frame_points(std::span<const Vec3> points, const Vec3& target, double fov_degrees, double aspect) {
    Camera camera{{}, target, fov_degrees};
    const double half = half_height(camera);
    double back = kNearestFrame;
    for (const Vec3& p : points) {
        const Vec3 d = p - target;
        const double reach = std::max(std::abs(d.y) / half, std::abs(d.x) / (half * aspect));
        back = std::max(back, d.z + kMargin * reach);
    }
    camera.position = target + Vec3{0, 0, points.empty() ? 1 : back};
    return camera;
}

Vec3 middle(std::span<const Vec3> points) {
    if (points.empty()) return {};
    Vec3 low = points.front();
    Vec3 high = low;
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return (low + high) / 2;
}

}  // namespace orbweaver::view
