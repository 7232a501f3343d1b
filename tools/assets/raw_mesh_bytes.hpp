#pragma once

#include <string>
#include <string_view>

#include "raw_mesh.hpp"

namespace orbweaver {

/// A raw mesh as bytes, to be handed from one process to another on the same machine.
std::string to_bytes(const mesh::RawMesh& raw);

/// Throws Fault(invalid) for bytes that are no mesh; what the mesh means is not checked. `name` stands for it
/// in sentences.
mesh::RawMesh raw_mesh_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace orbweaver
