#pragma once

#include <string>

#include "surface_mesh.hpp"
#include "validation.hpp"

namespace orbweaver::mesh {

/// Proves a mesh sound whose indices are (see mesh_in): joins its triangles anew and compares everything,
/// counts included. Throws Fault(invalid) for the first thing that differs; `name` stands for the mesh in the
/// sentence.
void verify(const SurfaceMesh& mesh, const Validation& validation, const std::string& name);

}  // namespace orbweaver::mesh
