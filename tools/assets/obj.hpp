#pragma once

#include <string>

#include "raw_mesh.hpp"

namespace orbweaver {

/// A mesh as Wavefront OBJ, every coordinate with all of its digits.
std::string obj_text(const mesh::RawMesh& raw);

}  // namespace orbweaver
