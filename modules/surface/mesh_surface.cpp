#include "mesh_surface.hpp"

#include <algorithm>
#include <utility>

#include "every_triangle.hpp"
#include "geodesic.hpp"
#include "stride.hpp"
#include "underfoot.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

namespace {

double largest_extent(const mesh::Bounds& bounds) noexcept {
    const Vec3 extent = bounds.max - bounds.min;
    return std::max({extent.x, extent.y, extent.z});
}

std::uint32_t shell_count(const mesh::SurfaceMesh& mesh) noexcept {
    return mesh.shell.empty() ? 0 : *std::max_element(mesh.shell.begin(), mesh.shell.end()) + 1;
}

/// As many as a node of a tree has children.
bool are_few(const mesh::SurfaceMesh& mesh) noexcept { return mesh.triangles.size() <= kWide; }

}  // namespace

MeshSurface::MeshSurface(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& baked,
                         GripOverrides grips)
    : mesh_(mesh),
      grips_(std::move(grips)),
      size_(largest_extent(mesh.bounds)),
      shells_(shell_count(mesh)),
      treeless_(!baked && are_few(mesh)),
      parts_(mesh, treeless_ ? WideTree{} : baked) {}

SurfaceGrip MeshSurface::grip(std::uint32_t face) const noexcept {
    return face < mesh_.property.size() ? grips_.grip(mesh_, face) : SurfaceGrip{};
}

Vec3 MeshSurface::position(const SurfacePoint& at) const noexcept {
    return position_of(triangles_of(mesh_), at);
}

Vec3 MeshSurface::normal(std::uint32_t face) const noexcept { return face_normal(triangles_of(mesh_), face); }

SurfaceHit MeshSurface::first_hit(const SurfaceRay& ray) const noexcept {
    if (!is_sound(ray)) return kRefusedHit;
    if (treeless_) return first_hit_of_all(triangles_of(mesh_), ray);
    const WideTree* tree = parts_.tree();
    if (tree == nullptr) return noted(kFailedHit, Answer::failed);
    return surface::first_hit(*tree, triangles_of(mesh_), ray);
}

SurfaceHit MeshSurface::closest_point(const Vec3& point, double reach) const noexcept {
    if (!is_finite(point) || !(reach >= 0)) return kRefusedHit;
    if (treeless_) return closest_point_of_all(triangles_of(mesh_), point, reach);
    const WideTree* tree = parts_.tree();
    if (tree == nullptr) return noted(kFailedHit, Answer::failed);
    return surface::closest_point(*tree, triangles_of(mesh_), point, reach);
}

Underfoot MeshSurface::underfoot(const Stance& stance) const noexcept {
    if (treeless_) return underfoot_few(stance);
    const Underfoot found = surface::underfoot(mesh_, parts_, stance);
    return noted(found, found.hit.answer);
}

// Two rings around any face are nearly all of so few: a body that has lost its own begins at the first.
Underfoot MeshSurface::underfoot_few(Stance stance) const noexcept {
    const auto set = triangles_of(mesh_);
    if (stance.last >= mesh_.triangles.size()) {
        stance.last = 0;
        stance.side = dot(stance.up, face_normal(set, 0)) < 0 ? -1 : 1;
    }
    const Underfoot found = surface::underfoot(mesh_, parts_, stance);
    if (found.hit.answer != Answer::nothing) return found;
    const SurfaceHit below = first_hit_of_all(set, {stance.position, -stance.up, stance.reach});
    if (below.answer == Answer::found) return {below, FoundBy::tree};
    return {closest_point_of_all(set, stance.position, stance.reach), FoundBy::tree};
}

SurfaceStep MeshSurface::place(const SurfacePoint& at, const Vec3& up, const Vec3& forward) const noexcept {
    return surface::place(mesh_, at, up, forward);
}

SurfaceStep MeshSurface::step(const Footing& from, double length) const noexcept {
    return surface::step(mesh_, from, length);
}

SurfaceStride MeshSurface::stride(const Footing& from, double length,
                                  std::span<StrideCorner> corners) const noexcept {
    const SurfaceStride found = surface::stride(mesh_, shells_, parts_, from, length, corners);
    return noted(found, found.step.answer);
}

}  // namespace orbweaver::surface
