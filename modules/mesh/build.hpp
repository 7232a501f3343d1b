#pragma once

#include <map>
#include <string>

#include "raw_mesh.hpp"
#include "surface_mesh.hpp"
#include "validation.hpp"

namespace orbweaver::mesh {

/// How a mesh becomes a surface.
struct Recipe {
    double weld_tolerance = 0;                          ///< m; 0: only points of equal coordinates are one
    std::map<std::string, SurfaceProperty> properties;  ///< by material; materials without one get the default
};

/// What a builder of another number makes of the same source differs: part of every cache's key.
inline constexpr std::uint32_t kBuilderVersion = 3;

/// Welds, triangulates, drops what has no area or was there before, and joins what remains. `name` stands for
/// the mesh in sentences. Throws Fault(invalid) for a mesh that is refused (see check), one of which nothing
/// remains, or a recipe that names a material it lacks.
SurfaceMeshData build_surface_mesh(const RawMesh& raw, const Recipe& recipe, const std::string& name,
                                   Validation& validation);

/// Fills in what follows from the triangles of a mesh alone: neighbours, rings, fans, shells and bounds, and
/// what is to be said of them. Its vertices are all used, its triangles have three different ones each.
void join(SurfaceMeshData& mesh, Validation& validation);

}  // namespace orbweaver::mesh
