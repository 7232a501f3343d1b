#include "bake_mesh.hpp"

#include "baked/content_hash.hpp"
#include "import_mesh.hpp"
#include "mesh_file.hpp"
#include "orbweaver/fault.hpp"

namespace orbweaver {

mesh::Validation bake_mesh(const std::string& source, const mesh::Recipe& recipe, const ChildLimits& limits,
                           const std::string& output) {
    if (is_baked_file(source))
        throw Fault(FaultKind::invalid, source + ": is baked already; name what it was made from");
    const mesh::RawMesh raw = import_mesh(source, limits);
    mesh::Validation validation;
    const mesh::SurfaceMeshData surface = mesh::build_surface_mesh(raw, recipe, source, validation);
    BakedWriter writer(mesh::kMeshType, mesh::kMeshVersion, hash_file(source));
    mesh::add_mesh(writer, surface.view(), validation);
    writer.write(output);
    return validation;
}

}  // namespace orbweaver
