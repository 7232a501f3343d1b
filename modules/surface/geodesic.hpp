#pragma once

#include "walker.hpp"

namespace orbweaver::surface {

/// Edges and vertices that a step may cross before it is stopped.
inline constexpr std::uint32_t kMostCrossings = 100'000;

/// Whether a footing means something on this mesh.
bool is_sound(const mesh::SurfaceMesh& mesh, const Footing& footing) noexcept;

/// See Surface::place. Refused when `forward` stands straight up from the face.
SurfaceStep place(const mesh::SurfaceMesh& mesh, const SurfacePoint& at, const Vec3& up,
                  const Vec3& forward) noexcept;

/// See Surface::step: the straightest geodesic of Polthier and Schmies (1998). Over an edge the next face is
/// unfolded into the plane of this one; at a vertex the angle is halved; at a border it stops.
SurfaceStep step(const mesh::SurfaceMesh& mesh, const Footing& from, double length) noexcept;

}  // namespace orbweaver::surface
