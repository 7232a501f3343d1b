#include "mesh_file.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "sample_meshes.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

template <class T, class U>
bool same(std::span<T> a, const std::vector<U>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// Writes a mesh, right or wrong, and reads it back: the sentence that it is refused with, behind the file's
/// name.
std::string refusal(const SurfaceMeshData& data) {
    const test::Scratch folder;
    const Validation validation;
    BakedWriter writer(kMeshType, kMeshVersion, {});
    add_mesh(writer, data.view(), validation);
    writer.write(folder.path("f"));
    try {
        const BakedFile file(folder.path("f"), kMeshType, kMeshVersion);
        mesh_in(file);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::invalid);
        return std::string(fault.what()).substr(folder.path("f").size() + 2);
    }
    return "";
}

}  // namespace

TEST_CASE("every shape comes back from its file as it was", "[unit]") {
    const test::Scratch folder;
    for (const Shape& shape : shapes()) {
        INFO(shape.name);
        Validation validation;
        const SurfaceMeshData data = test::build(shape.make(1, 3), validation);
        BakedWriter writer(kMeshType, kMeshVersion, {5, 6});
        add_mesh(writer, data.view(), validation);
        writer.write(folder.path("f"));
        const BakedFile file(folder.path("f"), kMeshType, kMeshVersion);
        const SurfaceMesh mesh = mesh_in(file);
        CHECK(same(mesh.vertices, data.vertices));
        CHECK(same(mesh.triangles, data.triangles));
        CHECK(same(mesh.across, data.across));
        CHECK(same(mesh.ring_first, data.ring_first));
        CHECK(same(mesh.ring, data.ring));
        CHECK(same(mesh.fan_first, data.fan_first));
        CHECK(same(mesh.fan, data.fan));
        CHECK(same(mesh.polygon, data.polygon));
        CHECK(same(mesh.shell, data.shell));
        CHECK(same(mesh.property, data.property));
        CHECK(same(mesh.properties, data.properties));
        CHECK(same(mesh.material_names, data.material_names));
        CHECK(mesh.bounds == data.bounds);
        CHECK(validation_in(file) == validation);
    }
}

TEST_CASE("a file in which an index leads out of the mesh is refused", "[unit]") {
    const std::string again = "; bake it again with orbweaver-assets";
    const std::vector<std::pair<const char*, void (*)(SurfaceMeshData&)>> cases = {
        {"triangles names element 21 of 21", [](SurfaceMeshData& m) { m.triangles[3][1] = 21; }},
        {"ring names element 24 of 24", [](SurfaceMeshData& m) { m.ring[0] = 24; }},
        {"shell names element 4294967295 of 24", [](SurfaceMeshData& m) { m.shell[1] = kNone; }},
        {"property names element 1 of 1", [](SurfaceMeshData& m) { m.property[2] = 1; }},
        {"across or fan names no edge of a triangle",
         [](SurfaceMeshData& m) { m.across[0][0] = across_code(24, 0, false); }},
        {"across or fan names no edge of a triangle",
         [](SurfaceMeshData& m) { m.across[0][0] = across_code(1, 3, false); }},
        {"across or fan names no edge of a triangle", [](SurfaceMeshData& m) { m.fan[0] = 4 * 24; }},
        {"across or fan names no edge of a triangle", [](SurfaceMeshData& m) { m.fan[0] = 3; }},
        {"ring_first has wrong ends", [](SurfaceMeshData& m) { m.ring_first[0] = 1; }},
        {"ring_first does not ascend", [](SurfaceMeshData& m) { m.ring_first[5] = 0; }},
        {"fan_first does not ascend", [](SurfaceMeshData& m) { m.fan_first[1] = 2; }},
        {"polygon has 23 records; expected 24", [](SurfaceMeshData& m) { m.polygon.pop_back(); }},
        {"ring_first has 23 records; expected 22", [](SurfaceMeshData& m) { m.ring_first.push_back(66); }},
        {"it has no triangle, or too many", [](SurfaceMeshData& m) { m.triangles.clear(); }},
        {"a vertex is not finite",
         [](SurfaceMeshData& m) { m.vertices[1].y = std::numeric_limits<double>::infinity(); }},
        {"a vertex is not finite",
         [](SurfaceMeshData& m) { m.bounds.max.z = std::numeric_limits<double>::quiet_NaN(); }}};
    const SurfaceMeshData sound = test::build(fan(1, 2));  // 24 triangles, 21 vertices
    REQUIRE(refusal(sound).empty());
    for (const auto& [sentence, spoil] : cases) {
        SurfaceMeshData data = sound;
        spoil(data);
        CHECK(refusal(data) == "is unsound: " + std::string(sentence) + again);
    }
}
