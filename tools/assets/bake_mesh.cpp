#include "bake_mesh.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>

#include "baked/content_hash.hpp"
#include "import_mesh.hpp"
#include "import_rounding.hpp"
#include "mesh_cache.hpp"
#include "mesh_file.hpp"
#include "orbweaver/fault.hpp"
#include "tree_file.hpp"

namespace orbweaver {

namespace {

namespace fs = std::filesystem;

std::vector<mesh::Companion> hash_companions(const std::string& source, const std::vector<std::string>& paths) {
    std::vector<mesh::Companion> companions;
    const fs::path folder = fs::absolute(source).parent_path();
    std::error_code ignored;
    for (const std::string& path : paths)
        if (fs::is_regular_file(path, ignored))
            companions.push_back({fs::absolute(path).lexically_relative(folder).string(), hash_file(path)});
    return companions;
}

}  // namespace

mesh::Validation bake_mesh(const std::string& source, const mesh::Recipe& recipe, const ChildLimits& limits,
                           const std::string& output) {
    if (is_baked_file(source))
        throw Fault(FaultKind::invalid, source + ": is baked already; name what it was made from");
    if (std::error_code ignored; fs::equivalent(source, output, ignored))
        throw Fault(FaultKind::invalid, output + ": is what is to be baked; name another file to write");
    const ImportedMesh imported = import_mesh(source, limits);
    mesh::check(imported.raw, source);
    const ImportRounding rounding = import_rounding(imported.raw);
    if (rounding.polygons > 0) spdlog::warn("{}", rounding_sentence(rounding, imported.raw, source));
    mesh::Validation validation;
    const mesh::SurfaceMeshData built = mesh::build_surface_mesh(imported.raw, recipe, source, validation);
    validation.rounded_polygons = rounding.polygons;
    BakedWriter writer(mesh::kMeshType, mesh::kMeshVersion, hash_file(source));
    mesh::add_mesh(writer, built.view(), validation);
    const surface::WideTreeData tree = surface::build_wide_tree({built.vertices, built.triangles});
    surface::add_tree(writer, tree);
    const auto companions = mesh::to_section(hash_companions(source, imported.companions));
    writer.add("companions", std::span<const char>(companions));
    writer.write(output);
    return validation;
}

}  // namespace orbweaver
