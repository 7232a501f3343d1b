#pragma once

#include <string>

#include "build.hpp"
#include "limited_child.hpp"
#include "validation.hpp"

namespace orbweaver {

/// Imports a mesh, builds its surface and writes it as a baked file. Returns what was found in it. Throws Fault
/// as import_mesh, build_surface_mesh and AtomicFile do, and for a source that is baked already.
mesh::Validation bake_mesh(const std::string& source, const mesh::Recipe& recipe, const ChildLimits& limits,
                           const std::string& output);

}  // namespace orbweaver
