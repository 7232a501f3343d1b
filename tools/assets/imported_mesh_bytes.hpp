#pragma once

#include <string>
#include <string_view>

#include "import_mesh.hpp"

namespace orbweaver {

/// An imported mesh as bytes, to be handed from one process to another on the same machine.
std::string to_bytes(const ImportedMesh& mesh);

/// Throws Fault(invalid) for bytes that are no mesh; what the mesh means is not checked. `name` stands for it
/// in sentences.
ImportedMesh imported_mesh_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace orbweaver
