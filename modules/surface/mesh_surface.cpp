#include "mesh_surface.hpp"

#include <algorithm>

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

Clearance failed_clearance() noexcept {
    Clearance clearance;
    clearance.answer = Answer::failed;
    return clearance;
}

}  // namespace

MeshSurface::MeshSurface(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& baked,
                         const GripOverride& grip)
    : mesh_(mesh),
      grip_(grip),
      size_(largest_extent(mesh.bounds)),
      shells_(shell_count(mesh)),
      parts_(mesh, baked),
      clearance_([set = triangles_of(mesh)] { return std::make_unique<const FclClearance>(set); }) {}

SurfaceGrip MeshSurface::grip(std::uint32_t face) const noexcept {
    if (face >= mesh_.property.size()) return {};
    const mesh::SurfaceProperty& baked = mesh_.properties[mesh_.property[face]];
    return {grip_.friction.value_or(baked.friction), grip_.climbable.value_or(baked.climbable != 0)};
}

Vec3 MeshSurface::position(const SurfacePoint& at) const noexcept {
    return position_of(triangles_of(mesh_), at);
}

Vec3 MeshSurface::normal(std::uint32_t face) const noexcept { return face_normal(triangles_of(mesh_), face); }

SurfaceHit MeshSurface::first_hit(const SurfaceRay& ray) const noexcept {
    if (!is_sound(ray)) return kRefusedHit;
    const WideTree* tree = parts_.tree();
    if (tree == nullptr) return noted(kFailedHit, Answer::failed);
    return surface::first_hit(*tree, triangles_of(mesh_), ray);
}

SurfaceHit MeshSurface::closest_point(const Vec3& point, double reach) const noexcept {
    if (!is_finite(point) || !(reach >= 0)) return kRefusedHit;
    const WideTree* tree = parts_.tree();
    if (tree == nullptr) return noted(kFailedHit, Answer::failed);
    return surface::closest_point(*tree, triangles_of(mesh_), point, reach);
}

Underfoot MeshSurface::underfoot(const Stance& stance) const noexcept {
    const Underfoot found = surface::underfoot(mesh_, parts_, stance);
    return noted(found, found.hit.answer);
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

Clearance MeshSurface::clearance(const ProbeBody& body, double reach) const noexcept {
    const FclClearance* fcl = clearance_.get();
    const Clearance found = fcl == nullptr ? failed_clearance() : fcl->clearance(body, reach);
    return noted(found, found.answer);
}

Clearance MeshSurface::clearance(const ProbeBody& body, const ProbeBody& other) const noexcept {
    const Clearance found = body_clearance(body, other);
    return noted(found, found.answer);
}

std::size_t MeshSurface::clearance_bytes() const noexcept {
    const FclClearance* fcl = clearance_.made();
    return fcl == nullptr ? 0 : fcl->memory_bytes();
}

}  // namespace orbweaver::surface
