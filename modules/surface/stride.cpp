#include "stride.hpp"

#include <algorithm>
#include <cmath>

#include "geodesic.hpp"

namespace orbweaver::surface {

using mesh::SurfaceMesh;

namespace {

/// How high above the surface a stride feels its way, and how far beyond a border: of the surface's size.
constexpr double kFeeler = 1e-7;

class Stride {
public:
    Stride(const SurfaceMesh& mesh, std::uint32_t shells, const ReadyParts& parts, const Footing& from,
           const Vec3& ahead, std::span<StrideCorner> corners) noexcept
        : mesh_(mesh),
          shells_(shells),
          parts_(parts),
          walker_(mesh, from.at, from.side, ahead),
          corners_(corners) {
        const Vec3 extent = mesh.bounds.max - mesh.bounds.min;
        feeler_ = kFeeler * std::max({extent.x, extent.y, extent.z});
    }

    SurfaceStride run(double length) noexcept {
        result_.step.answer = Answer::found;
        double left = length;
        while (result_.step.stop == StepStop::none) {
            const Walker before = walker_;
            const Vec3 up = walker_.up();
            const bool met = walker_.advance(left) != Walker::Met::nothing;
            if (shells_ > 1 && climb(before, up, left)) continue;
            left -= walker_.advanced();
            result_.step.walked += walker_.advanced();
            if (!met) break;
            pass(up);
        }
        if (result_.step.stop == StepStop::none) result_.step.walked = length;
        result_.step.end = walker_.footing();
        return result_;
    }

private:
    /// From where `before` was, along the advance just made: is another shell in the way? Then on to it.
    bool climb(const Walker& before, const Vec3& up, double& left) noexcept {
        const Vec3 lift = feeler_ * up;
        const SurfaceRay ray{before.position() + lift, before.direction(), walker_.advanced()};
        const SurfaceHit wall = cast(ray);
        if (wall.answer != Answer::found || mesh_.shell[wall.at.face] == mesh_.shell[before.at().face])
            return false;
        if (!count_crossing()) return true;
        const Vec3 normal = face_normal(triangles_of(mesh_), wall.at.face);
        const Vec3 towards = dot(normal, before.direction()) < 0 ? normal : -normal;
        const Vec3 along = cross(up, towards);
        const Vec3 rise = in_plane(mesh_, wall.at.face, up);
        if (along == Vec3{} || rise == Vec3{}) return false;  // flat on the floor: nothing to climb
        const Vec3 crease = unit(along);
        const double aside = dot(before.direction(), crease);
        const double ahead = std::sqrt(std::max(0.0, 1 - aside * aside));
        const Vec3 climbing = unit(cross(towards, crease));
        const Vec3 upwards = dot(climbing, up) < 0 ? -climbing : climbing;
        left -= wall.distance;
        result_.step.walked += wall.distance;
        walker_.jump(wall.at, towards == normal ? 1 : -1, unit(aside * crease + ahead * upwards));
        note_corner(up, before.direction());
        return true;
    }

    /// Over the edge, vertex or border that was met.
    void pass(const Vec3& up) noexcept {
        if (!count_crossing()) return;
        const Vec3 direction = walker_.direction();
        if (!walker_.cross() && !bridge(up)) {
            result_.step.stop = StepStop::border;
            return;
        }
        note_corner(up, direction);
    }

    /// Over a border whose neighbour lies where it would be, only not joined to it: as at a T-junction.
    bool bridge(const Vec3& up) noexcept {
        const Vec3 beyond = walker_.position() + feeler_ * walker_.direction();
        const SurfaceHit hit = cast({beyond + feeler_ * up, -up, 2 * feeler_});
        if (hit.answer != Answer::found || hit.at.face == walker_.at().face) return false;
        const Vec3 ahead = in_plane(mesh_, hit.at.face, walker_.direction());
        if (ahead == Vec3{}) return false;
        walker_.jump(hit.at, dot(face_normal(triangles_of(mesh_), hit.at.face), up) < 0 ? -1 : 1, ahead);
        return true;
    }

    SurfaceHit cast(const SurfaceRay& ray) noexcept {
        const WideTree* tree = parts_.tree();
        if (tree != nullptr) return first_hit(*tree, triangles_of(mesh_), ray);
        result_.step.answer = Answer::failed;
        return {};
    }

    bool count_crossing() noexcept {
        if (result_.step.crossings == kMostCrossings) {
            result_.step.stop = StepStop::limit;
            return false;
        }
        ++result_.step.crossings;
        return true;
    }

    void note_corner(const Vec3& up_before, const Vec3& direction_before) noexcept {
        const Vec3 up = walker_.up();
        constexpr double kFlat = 1e-6;  // rad, below which two faces are one plane
        if (norm(up - up_before) < kFlat) return;
        if (result_.corners < corners_.size())
            corners_[result_.corners] = {result_.step.walked, walker_.position(), up_before, up,
                                         dot(up, direction_before) < 0};
        ++result_.corners;
    }

    const SurfaceMesh& mesh_;
    std::uint32_t shells_;
    const ReadyParts& parts_;
    Walker walker_;
    std::span<StrideCorner> corners_;
    double feeler_ = 0;
    SurfaceStride result_;
};

}  // namespace

SurfaceStride stride(const SurfaceMesh& mesh, std::uint32_t shells, const ReadyParts& parts,
                     const Footing& from, double length, std::span<StrideCorner> corners) noexcept {
    if (!is_sound(mesh, from) || !(length >= 0) || !std::isfinite(length)) return {};
    const Vec3 ahead = in_plane(mesh, from.at.face, from.forward);
    if (ahead == Vec3{}) return {};
    return Stride(mesh, shells, parts, from, ahead, corners).run(length);
}

}  // namespace orbweaver::surface
