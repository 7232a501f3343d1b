#include "geodesic.hpp"

#include <cmath>

namespace orbweaver::surface {

using mesh::SurfaceMesh;

namespace {

bool is_sound(const SurfaceMesh& mesh, const SurfacePoint& at) noexcept {
    constexpr double kRounding = 1e-9;
    if (at.face >= mesh.triangles.size()) return false;
    double sum = 0;
    for (const double w : at.weights) {
        if (!(w >= -kRounding)) return false;
        sum += w;
    }
    return std::abs(sum - 1) <= kRounding;
}

}  // namespace

bool is_sound(const SurfaceMesh& mesh, const Footing& footing) noexcept {
    return is_sound(mesh, footing.at) && (footing.side == 1 || footing.side == -1) &&
           is_finite(footing.forward);
}

SurfaceStep place(const SurfaceMesh& mesh, const SurfacePoint& at, const Vec3& up,
                  const Vec3& forward) noexcept {
    SurfaceStep placed;
    if (!is_sound(mesh, at) || !is_finite(up) || !is_finite(forward)) return placed;
    const int side = dot(up, face_normal(triangles_of(mesh), at.face)) < 0 ? -1 : 1;
    const Vec3 ahead = in_plane(mesh, at.face, forward);
    if (ahead == Vec3{}) return placed;
    placed.answer = Answer::found;
    placed.end = Walker(mesh, at, side, ahead).footing();
    return placed;
}

SurfaceStep step(const SurfaceMesh& mesh, const Footing& from, double length) noexcept {
    SurfaceStep result;
    if (!is_sound(mesh, from) || !(length >= 0) || !std::isfinite(length)) return result;
    const Vec3 ahead = in_plane(mesh, from.at.face, from.forward);
    if (ahead == Vec3{}) return result;
    Walker walker(mesh, from.at, from.side, ahead);
    result.answer = Answer::found;
    for (double left = length; walker.advance(left) != Walker::Met::nothing;) {
        left -= walker.advanced();
        result.walked += walker.advanced();
        if (result.crossings == kMostCrossings || !walker.cross()) {
            result.stop = result.crossings == kMostCrossings ? StepStop::limit : StepStop::border;
            break;
        }
        ++result.crossings;
    }
    if (result.stop == StepStop::none) result.walked = length;
    result.end = walker.footing();
    return result;
}

}  // namespace orbweaver::surface
