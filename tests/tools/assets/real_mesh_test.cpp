#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "build.hpp"
#include "import_mesh.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

namespace {

/// What an OBJ says, read without any of our code or assimp's: faces over places, to single precision.
struct PlainObj {
    std::map<std::array<float, 3>, int> places;
    std::vector<std::vector<int>> faces;
};

PlainObj read_plainly(const std::string& path) {
    PlainObj obj;
    std::vector<int> place;
    std::istringstream lines(test::read_file(path));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            std::array<float, 3> p{};
            for (float& x : p) words >> x;
            place.push_back(obj.places.emplace(p, static_cast<int>(obj.places.size())).first->second);
        }
        if (word != "f") continue;
        obj.faces.emplace_back();
        while (words >> word) obj.faces.back().push_back(place.at(std::stoul(word) - 1));
    }
    return obj;
}

std::size_t used_places(const PlainObj& obj) {
    std::set<int> used;
    for (const auto& face : obj.faces) used.insert(face.begin(), face.end());
    return used.size();
}

/// How many edges have one, two, and more faces; an edge is a pair of places.
std::map<std::size_t, std::size_t> edges_by_faces(const PlainObj& obj) {
    std::map<std::pair<int, int>, std::size_t> faces_at;
    for (const auto& face : obj.faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            ++faces_at[std::minmax(face[i], face[(i + 1) % face.size()])];
    std::map<std::size_t, std::size_t> count;
    for (const auto& [edge, faces] : faces_at) ++count[std::min<std::size_t>(faces, 3)];
    return count;
}

}  // namespace

// place.
TEST_CASE("real meshes come in with the vertices and edges that their files have", "[unit]") {
    for (const char* name : {"fandisk", "spot", "stanford-bunny", "teapot"}) {
        INFO(name);
        const std::string path = std::string(ORBWEAVER_REAL_MESHES "/") + name + ".obj";
        const PlainObj plain = read_plainly(path);
        auto expected = edges_by_faces(plain);
        mesh::Validation found;
        const auto surface = mesh::build_surface_mesh(import_mesh(path, {}).raw, {}, name, found);
        CHECK(found.source_polygons == plain.faces.size());
        CHECK(found.border_edges == expected[1]);
        CHECK(found.nonmanifold_edges == expected[3]);
        CHECK(found.edges == expected[1] + expected[2] + expected[3]);
        CHECK(surface.vertices.size() == used_places(plain));
    }
}

TEST_CASE("published counts of real meshes are found again", "[unit]") {
    struct Known {
        const char* name;
        std::size_t vertices, triangles, border_edges, shells;
    };
    // The bunny's five holes have 223 edges (Stanford 3D Scanning Repository); fandisk and spot are closed.
    for (const Known& known : {Known{"fandisk", 6475, 12946, 0, 1}, Known{"spot", 2930, 5856, 0, 1},
                               Known{"stanford-bunny", 34834, 69451, 223, 1}}) {
        INFO(known.name);
        mesh::Validation found;
        const auto surface = mesh::build_surface_mesh(
            import_mesh(std::string(ORBWEAVER_REAL_MESHES "/") + known.name + ".obj", {}).raw, {}, known.name,
            found);
        CHECK(surface.vertices.size() == known.vertices);
        CHECK(surface.triangles.size() == known.triangles);
        CHECK(found.border_edges == known.border_edges);
        CHECK(found.shells == known.shells);
        CHECK(found.flipped == 0);
        CHECK(found.nonmanifold_vertices == 0);
    }
}
