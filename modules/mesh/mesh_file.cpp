#include "mesh_file.hpp"

#include <algorithm>

#include "orbweaver/fault.hpp"

namespace orbweaver::mesh {

namespace {

[[noreturn]] void refuse(const BakedFile& file, const std::string& what) {
    throw Fault(FaultKind::invalid,
                file.path() + ": is unsound: " + what + "; bake it again with orbweaver-assets");
}

void require_count(const BakedFile& file, const char* name, std::size_t found, std::size_t expected) {
    if (found != expected)
        refuse(file, std::string(name) + " has " + std::to_string(found) + " records; expected " +
                         std::to_string(expected));
}

// Largest first, compared once: the loop is free of branches, so that a million triangles take a millisecond.
template <class Index>
void require_below(const BakedFile& file, const char* name, std::span<const Index> indices, std::size_t limit) {
    Index largest = 0;
    for (const Index index : indices) largest = std::max(largest, index);
    if (!indices.empty() && largest >= limit)
        refuse(file, std::string(name) + " names element " + std::to_string(largest) + " of " +
                         std::to_string(limit));
}

std::span<const std::uint32_t> flat(std::span<const Triangle> triangles) {
    return {reinterpret_cast<const std::uint32_t*>(triangles.data()), 3 * triangles.size()};
}

void require_ascending(const BakedFile& file, const char* name, std::span<const std::uint32_t> first,
                       std::size_t least, std::size_t end) {
    if (first.empty() || first.front() != 0 || first.back() != end)
        refuse(file, std::string(name) + " has wrong ends");
    bool ascends = true;
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
        ascends &= first[i + 1] >= first[i] && first[i + 1] - first[i] >= least;
    if (!ascends) refuse(file, std::string(name) + " does not ascend");
}

void require_codes(const BakedFile& file, const SurfaceMesh& mesh) {
    const auto limit = static_cast<std::uint32_t>(mesh.triangles.size());
    bool sound = true;
    for (const std::uint32_t code : flat(mesh.across))
        sound &= code >= kNonManifold || (across_triangle(code) < limit && across_edge(code) < 3);
    for (const std::uint32_t face : mesh.fan) sound &= face / 4 < limit && face % 4 < 3;
    if (!sound) refuse(file, "across or fan names no edge of a triangle");
}

void require_finite(const BakedFile& file, const SurfaceMesh& mesh) {
    double sum = 0;  // 0 times what is finite is 0, and NaN times anything else
    for (const Vec3& v : mesh.vertices) sum += 0 * v.x + 0 * v.y + 0 * v.z;
    for (const Vec3& v : {mesh.bounds.min, mesh.bounds.max}) sum += 0 * v.x + 0 * v.y + 0 * v.z;
    if (sum != 0) refuse(file, "a vertex is not finite");
}

}  // namespace

void add_mesh(BakedWriter& writer, const SurfaceMesh& mesh, const Validation& validation) {
    writer.add_record("validation", validation);
    writer.add_record("bounds", mesh.bounds);
    writer.add("vertices", mesh.vertices);
    writer.add("triangles", mesh.triangles);
    writer.add("across", mesh.across);
    writer.add("ring_first", mesh.ring_first);
    writer.add("ring", mesh.ring);
    writer.add("fan_first", mesh.fan_first);
    writer.add("fan", mesh.fan);
    writer.add("polygon", mesh.polygon);
    writer.add("shell", mesh.shell);
    writer.add("property", mesh.property);
    writer.add("properties", mesh.properties);
    writer.add("materials", mesh.material_names);
}

SurfaceMesh mesh_in(const BakedFile& file) {
    SurfaceMesh mesh;
    mesh.vertices = file.section<Vec3>("vertices");
    mesh.triangles = file.section<Triangle>("triangles");
    mesh.across = file.section<Triangle>("across");
    mesh.ring_first = file.section<std::uint32_t>("ring_first");
    mesh.ring = file.section<std::uint32_t>("ring");
    mesh.fan_first = file.section<std::uint32_t>("fan_first");
    mesh.fan = file.section<std::uint32_t>("fan");
    mesh.polygon = file.section<std::uint32_t>("polygon");
    mesh.shell = file.section<std::uint32_t>("shell");
    mesh.property = file.section<std::uint16_t>("property");
    mesh.properties = file.section<SurfaceProperty>("properties");
    mesh.material_names = file.section<char>("materials");
    const auto bounds = file.section<Bounds>("bounds");
    require_count(file, "bounds", bounds.size(), 1);
    mesh.bounds = bounds[0];

    const std::size_t triangles = mesh.triangles.size();
    if (triangles == 0 || triangles > kMostTriangles) refuse(file, "it has no triangle, or too many");
    require_count(file, "across", mesh.across.size(), triangles);
    require_count(file, "ring", mesh.ring.size(), 3 * triangles);
    require_count(file, "ring_first", mesh.ring_first.size(), mesh.vertices.size() + 1);
    require_count(file, "polygon", mesh.polygon.size(), triangles);
    require_count(file, "shell", mesh.shell.size(), triangles);
    require_count(file, "property", mesh.property.size(), triangles);
    require_below(file, "triangles", flat(mesh.triangles), mesh.vertices.size());
    require_below(file, "ring", mesh.ring, triangles);
    require_below(file, "shell", mesh.shell, triangles);
    require_below(file, "property", mesh.property, mesh.properties.size());
    require_ascending(file, "ring_first", mesh.ring_first, 1, mesh.ring.size());
    require_ascending(file, "fan_first", mesh.fan_first, 3, mesh.fan.size());
    require_codes(file, mesh);
    require_finite(file, mesh);
    return mesh;
}

const Validation& validation_in(const BakedFile& file) {
    const auto validation = file.section<Validation>("validation");
    require_count(file, "validation", validation.size(), 1);
    return validation[0];
}

}  // namespace orbweaver::mesh
