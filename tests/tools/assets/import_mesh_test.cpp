#include "import_mesh.hpp"

#include <catch2/catch.hpp>

#include "build.hpp"
#include "obj.hpp"
#include "orbweaver/fault.hpp"
#include "shapes.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

namespace {

const ChildLimits kLimits{};

mesh::Validation surface_of(const mesh::RawMesh& raw, mesh::SurfaceMeshData* surface = nullptr) {
    mesh::Validation validation;
    auto built = mesh::build_surface_mesh(raw, {}, "sample", validation);
    if (surface != nullptr) *surface = std::move(built);
    return validation;
}

/// A unit tetrahedron as binary STL: separate triangles, a normal each.
std::string stl_tetrahedron() {
    const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::string bytes(80, ' ');
    const std::uint32_t count = 4;
    bytes.append(reinterpret_cast<const char*>(&count), 4);
    for (const auto& face : faces) {
        const float normal[3] = {0, 0, 1};
        bytes.append(reinterpret_cast<const char*>(normal), 12);
        for (const int corner : face) bytes.append(reinterpret_cast<const char*>(p[corner]), 12);
        bytes.append(2, '\0');
    }
    return bytes;
}

constexpr const char* kGltf = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0, "translation": [5, 0, 0], "scale": [-2, 2, 2]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
               {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
 "buffers": [{"uri": "triangle.bin", "byteLength": 42}]})";

std::string gltf_buffer() {
    const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::uint16_t indices[3] = {0, 1, 2};
    std::string bytes(reinterpret_cast<const char*>(points), 36);
    return bytes.append(reinterpret_cast<const char*>(indices), 6);
}

}  // namespace

// assimp keeps single precision, and splits corners: quads stay quads, and welding makes them one surface
// again.
TEST_CASE("shapes come back from OBJ with their polygons, neighbours and materials", "[unit]") {
    const test::Folder folder;
    for (const mesh::Shape& shape : mesh::shapes()) {
        INFO(shape.name);
        const mesh::RawMesh raw = shape.make(2, 4);
        const ImportedMesh imported = import_mesh(folder.write("m.obj", obj_text(raw)), kLimits);
        CHECK(imported.raw.material_names == raw.material_names);
        CHECK(imported.companions.empty());
        mesh::SurfaceMeshData expected, found;
        const mesh::Validation v = surface_of(raw, &expected), w = surface_of(imported.raw, &found);
        CHECK(w.source_polygons == v.source_polygons);
        CHECK(w.edges == v.edges);
        CHECK(w.border_edges == v.border_edges);
        CHECK(w.nonmanifold_edges == v.nonmanifold_edges);
        CHECK(w.shells == v.shells);
        CHECK(w.flipped == v.flipped);
        REQUIRE(found.vertices.size() == expected.vertices.size());
        double farthest = 0;
        for (std::size_t i = 0; i < found.vertices.size(); ++i)
            farthest = std::max(farthest, distance(found.vertices[i], expected.vertices[i]));
        CHECK(farthest < 2 * 6e-8 * 2);  // half a unit in the last place of single precision, times a size of 2
    }
}

TEST_CASE("attributes are dropped before points are joined", "[unit]") {
    // A square of two triangles whose shared corners differ in normals and texture coordinates.
    const test::Folder folder;
    const ImportedMesh imported =
        import_mesh(folder.write("m.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nvt 0 0\nvt 1 1\n"
                                 "f 1/1/1 2/1/1 3/1/1\nf 1/2/2 3/2/2 4/2/2\n"),
                    kLimits);
    const mesh::Validation found = surface_of(imported.raw);
    CHECK(found.edges == 5);
    CHECK(found.border_edges == 4);
    CHECK(found.shells == 1);
    const mesh::Validation stl = surface_of(import_mesh(folder.write("m.stl", stl_tetrahedron()), kLimits).raw);
    CHECK(stl.edges == 6);
    CHECK(stl.border_edges == 0);
    CHECK(stl.flipped == 0);
}

TEST_CASE("a file's nodes place its meshes, and a mirror does not turn them inside out", "[unit]") {
    const test::Folder folder;
    folder.write("triangle.bin", gltf_buffer());
    const ImportedMesh imported = import_mesh(folder.write("m.gltf", kGltf), kLimits);
    REQUIRE(imported.raw.corners.size() == 3);
    std::vector<Vec3> p;
    for (const std::uint32_t corner : imported.raw.corners) p.push_back(imported.raw.points[corner]);
    for (const Vec3& expected : {Vec3{5, 0, 0}, Vec3{3, 0, 0}, Vec3{5, 2, 0}})
        CHECK(std::count(p.begin(), p.end(), expected) == 1);
    CHECK(cross(p[1] - p[0], p[2] - p[0]).z == 4);
    CHECK(imported.companions == std::vector<std::string>{folder.path("triangle.bin")});
}

TEST_CASE("what cannot be imported is refused in words", "[unit]") {
    const test::Folder folder;
    const auto sentence = [](const std::string& path) {
        try {
            import_mesh(path, kLimits);
        } catch (const Fault& fault) {
            CHECK(fault.kind() == FaultKind::invalid);
            return std::string(fault.what()).substr(path.size() + 2);
        }
        return std::string();
    };
    CHECK(sentence(folder.path("none.obj")) == "there is no such file; name a mesh, such as cube.obj");
    CHECK(sentence(folder.path()) == "is not a regular file; name a mesh, such as cube.obj");
    CHECK(sentence("/dev/zero") == "is not a regular file; name a mesh, such as cube.obj");
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"m.obj", ""},
             {"m.obj", "v 0 0 0\nf 1 2 3\n"},
             {"m.unknown", "v 0 0 0"},
             {"m.stl", std::string(84, '\xff')},
             {"m.gltf",
              "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"uri\": \"no.bin\", \"byteLength\": 9}]}"},
             {"m.glb", "glTF\x02" + std::string(40, '\xff')}}) {
        INFO(name << ": " << text);
        CHECK(sentence(folder.write(name, text)).find("; export the mesh again, or in another format") !=
              std::string::npos);
    }
}

TEST_CASE("a mesh that says it is larger than memory is a limit that was hit", "[unit]") {
    const test::Folder folder;
    const std::string path = folder.write(
        "m.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n");
    try {
        import_mesh(path, kLimits);
        FAIL("it was imported");
    } catch (const Fault& fault) {
#if defined(__SANITIZE_ADDRESS__)  // which ends a process that asks for that much
        CHECK(fault.kind() == FaultKind::invalid);
#else
        CHECK(fault.kind() == FaultKind::limit);
        CHECK(std::string(fault.what()).find("takes more than") != std::string::npos);
#endif
    }
}

TEST_CASE("no single broken byte of a file gets past the importer's process", "[extreme]") {
    const test::Folder folder;
    const std::string sound = stl_tetrahedron();
    for (std::size_t i = 0; i < sound.size(); i += 3) {
        std::string broken = sound;
        broken[i] = static_cast<char>(broken[i] ^ 0xff);
        try {
            mesh::Validation validation;
            mesh::build_surface_mesh(import_mesh(folder.write("m.stl", broken), kLimits).raw, {}, "m",
                                     validation);
        } catch (const Fault& fault) {
            CHECK((fault.kind() == FaultKind::invalid || fault.kind() == FaultKind::limit));
        }
    }
}
