#pragma once

#include "orbweaver/contracts/surface.hpp"
#include "ready_parts.hpp"
#include "surface_mesh.hpp"

namespace orbweaver::surface {

/// Which polygon a body is on, cheapest way first; see Surface::underfoot. The ray from the body's origin
/// against its up is tried on
///   1. the face it was last on;
///   2. the faces that a walk across edges leads to, each time over the edge that the ray passes outside of;
///   3. the faces around that one's corners, and around theirs (the rings of ap Cenydd and Teahan 2005, 3.2);
/// then 4. rays that scan back and forth along the forward axis, and from side to side, at growing angles, over
/// the same rings (the same, for edges that drop away under the body); then 5. the ray, the scan and the
/// nearest point over the whole surface, which asks for the tree.
Underfoot underfoot(const mesh::SurfaceMesh& mesh, const ReadyParts& parts, const Stance& stance) noexcept;

}  // namespace orbweaver::surface
