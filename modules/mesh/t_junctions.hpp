#pragma once

#include "surface_mesh.hpp"
#include "validation.hpp"

namespace orbweaver::mesh {

/// Counts the vertices on borders that lie on another border edge, between its ends: where faces meet that no
/// edge joins. Near enough is a millionth of the edge, and what single precision rounds its ends by. About
/// n log n in the border edges; closed meshes cost nothing.
void find_t_junctions(const SurfaceMesh& mesh, Validation& into);

}  // namespace orbweaver::mesh
