#pragma once

#include <cstdint>
#include <string_view>

#include "baked/baked_writer.hpp"
#include "orbweaver/baked_file.hpp"
#include "surface_mesh.hpp"
#include "validation.hpp"

namespace orbweaver::mesh {

inline constexpr std::string_view kMeshType = "mesh";
/// Of the sections below and of the tree that lies beside them; others are refused.
inline constexpr std::uint32_t kMeshVersion = 3;

/// Adds a mesh's sections. What its arrays view is not copied: it outlives the writer.
void add_mesh(BakedWriter& writer, const SurfaceMesh& mesh, const Validation& validation);

/// The mesh in a file of kMeshType and kMeshVersion, where it lies: valid while the file lives. Throws
/// Fault(invalid) for sections that disagree in number and for any index without its element, so that what is
/// returned can be walked without leaving memory; that neighbours are mutual is for `verify` to prove.
SurfaceMesh mesh_in(const BakedFile& file);

const Validation& validation_in(const BakedFile& file);

}  // namespace orbweaver::mesh
