#include "plane.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace orbweaver::web {

namespace {

constexpr double kUndecided = 1e-9;  // components of unit vectors smaller than this do not decide

Vec3 facing_viewer(const Vec3& normal) noexcept {
    for (const double component : {normal.z, normal.x, normal.y})
        if (std::abs(component) > kUndecided) return component < 0 ? -normal : normal;
    return normal;
}

}  // namespace

Plane upright_plane(const Vec3& origin, Vec3 normal) noexcept {
    normal = facing_viewer(normal);
    Vec3 up = Vec3{0, 1, 0} - normal * normal.y;
    if (norm(up) < 1e-6) up = Vec3{0, 0, -1} - normal * -normal.z;  // a web that lies flat: up is away
    up = up / norm(up);
    return {origin, cross(up, normal), up, normal};
}

PlaneFit fit_plane(std::span<const Vec3> points) {
    const auto count = static_cast<double>(points.size());
    Vec3 centroid;
    for (const Vec3& p : points) centroid += p / count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& p : points) {
        const Eigen::Vector3d d(p.x - centroid.x, p.y - centroid.y, p.z - centroid.z);
        spread += d * d.transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);  // eigenvalues ascending
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    PlaneFit fit;
    fit.plane = upright_plane(centroid, {n.x(), n.y(), n.z()});
    fit.length = std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
    fit.width = std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
    return fit;
}

}  // namespace orbweaver::web
