#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limited_child.hpp"
#include "raw_mesh.hpp"

namespace orbweaver {

inline constexpr std::uintmax_t kLargestSource = std::uintmax_t{2} << 30;  ///< bytes

struct ImportedMesh {
    mesh::RawMesh raw;
    std::vector<std::string> companions;  ///< paths of the other files that the importer read
};

/// Imports any file that assimp reads, in a child process with limits: polygons as they are, in the place that
/// the file's nodes give them, and the materials that they use; normals, texture coordinates, colours and
/// tangents are dropped before anything is joined. Coordinates are of single precision, as assimp keeps them.
/// Throws Fault(invalid) for a file that is not there, cannot be imported, or on which the importer crashes;
/// Fault(limit) for one beyond the limits.
ImportedMesh import_mesh(const std::string& path, const ChildLimits& limits);

}  // namespace orbweaver
