#pragma once

#include <cstdint>
#include <string>

#include "raw_mesh.hpp"
#include "surface_mesh.hpp"

namespace orbweaver {

/// An edge that may have become this much longer or shorter of itself is told.
inline constexpr double kToldChange = 0.01;

/// What single precision, in which assimp keeps coordinates, may have done to a mesh.
struct ImportRounding {
    std::uint32_t polygons = 0;         ///< with an edge that may have changed by more than kToldChange
    std::uint32_t first = mesh::kNone;  ///< of them
    double worst = 0;                   ///< m, by which a corner of theirs may lie beside its place
    double farthest = 0;                ///< m, largest coordinate of their corners
};

/// Bounds by half a unit in the last place of each coordinate. An edge without length was no edge, unless such
/// an error is more than kToldChange of the mesh's mean edge.
ImportRounding import_rounding(const mesh::RawMesh& raw);

/// What is to be said of a mesh with such polygons, and the remedy. `name` stands for it.
std::string rounding_sentence(const ImportRounding& rounding, const mesh::RawMesh& raw,
                              const std::string& name);

}  // namespace orbweaver
