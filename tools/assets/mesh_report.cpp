#include "mesh_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mesh_file.hpp"

namespace orbweaver {

namespace {

using mesh::SurfaceMesh;
using mesh::Validation;

std::size_t polygon_count(const SurfaceMesh& mesh) {
    std::size_t count = 1;
    for (std::size_t t = 1; t < mesh.polygon.size(); ++t) count += mesh.polygon[t] != mesh.polygon[t - 1];
    return count;
}

std::string found(const char* what, std::uint64_t count, const char* where, std::uint32_t first) {
    if (count == 0) return "";
    return fmt::format("  {:<22}{}{}\n", what, count,
                       first == mesh::kNone ? "" : fmt::format(" (first: {} {})", where, first));
}

std::string findings(const Validation& v) {
    return found("welded points", v.welded_points, "", mesh::kNone) +
           found("unused points", v.unused_points, "", mesh::kNone) +
           found("rounded polygons", v.rounded_polygons, "", mesh::kNone) +
           found("dropped degenerate", v.dropped_degenerate, "polygon", v.first_degenerate) +
           found("dropped duplicate", v.dropped_duplicate, "polygon", v.first_duplicate) +
           found("border edges", v.border_edges, "triangle", v.first_border) +
           found("T-junctions", v.t_junctions, "vertex", v.first_t_junction) +
           found("non-manifold edges", v.nonmanifold_edges, "triangle", v.first_nonmanifold) +
           found("non-manifold vertices", v.nonmanifold_vertices, "vertex", v.first_nonmanifold_vertex) +
           found("flipped triangles", v.flipped, "triangle", v.first_flipped) +
           found("one-sided shells", v.one_sided_shells, "", mesh::kNone);
}

std::string materials(const SurfaceMesh& mesh) {
    std::string text;
    for (std::size_t i = 0; i < mesh.properties.size(); ++i)
        text +=
            fmt::format("  '{}': friction {}, {}\n", mesh::material_name(mesh, i), mesh.properties[i].friction,
                        mesh.properties[i].climbable != 0 ? "climbable" : "not climbable");
    return text;
}

nlohmann::ordered_json array_of(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string mesh_text(const BakedFile& file) {
    const SurfaceMesh mesh = mesh::mesh_in(file);
    const Validation& v = mesh::validation_in(file);
    const Vec3& low = mesh.bounds.min;
    const Vec3& high = mesh.bounds.max;
    const std::string listed = findings(v);
    std::string text = fmt::format(
        "{}: a mesh, version {}, {} bytes, from source {}\n"
        "  {} triangles of {} polygons, {} vertices, {} edges, {} shell{}\n"
        "  x {:g} to {:g} m, y {:g} to {:g} m, z {:g} to {:g} m\n",
        file.path(), mesh::kMeshVersion, file.size(), to_string(file.source_hash()), mesh.triangles.size(),
        polygon_count(mesh), mesh.vertices.size(), v.edges, v.shells, v.shells == 1 ? "" : "s", low.x, high.x,
        low.y, high.y, low.z, high.z);
    text += "materials\n" + materials(mesh);
    text += "validation of the source\n" +
            (listed.empty() ? "  nothing to say: one surface, closed and sound\n" : listed);
    return text;
}

std::string mesh_json(const BakedFile& file) {
    const SurfaceMesh mesh = mesh::mesh_in(file);
    const Validation& v = mesh::validation_in(file);
    nlohmann::ordered_json json = {
        {"kind", mesh::kMeshType},
        {"version", mesh::kMeshVersion},
        {"source_hash", to_string(file.source_hash())},
        {"bytes", file.size()},
        {"triangles", mesh.triangles.size()},
        {"polygons", polygon_count(mesh)},
        {"vertices", mesh.vertices.size()},
        {"edges", v.edges},
        {"border_edges", v.border_edges},
        {"t_junctions", v.t_junctions},
        {"nonmanifold_edges", v.nonmanifold_edges},
        {"nonmanifold_vertices", v.nonmanifold_vertices},
        {"shells", v.shells},
        {"one_sided_shells", v.one_sided_shells},
        {"flipped", v.flipped},
        {"dropped_degenerate", v.dropped_degenerate},
        {"dropped_duplicate", v.dropped_duplicate},
        {"rounded_polygons", v.rounded_polygons},
        {"welded_points", v.welded_points},
        {"unused_points", v.unused_points},
        {"source_points", v.source_points},
        {"source_polygons", v.source_polygons},
        {"bounds", {{"min", array_of(mesh.bounds.min)}, {"max", array_of(mesh.bounds.max)}}}};
    auto& listed = json["materials"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < mesh.properties.size(); ++i)
        listed.push_back({{"name", mesh::material_name(mesh, i)},
                          {"friction", mesh.properties[i].friction},
                          {"climbable", mesh.properties[i].climbable != 0}});
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace orbweaver
