#include "mesh_cache.hpp"

#include <catch2/catch.hpp>

#include "baked/content_hash.hpp"
#include "cache_environment.hpp"
#include "mesh_file.hpp"
#include "orbweaver/fault.hpp"
#include "sample_meshes.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

using Environment = test::CacheEnvironment;

void bake_into(const std::string& path, std::span<const Companion> companions = {}) {
    Validation validation;
    const SurfaceMeshData mesh = test::build(cube(1, 1), validation);
    const std::vector<char> section = to_section(companions);
    BakedWriter writer(kMeshType, kMeshVersion, {});
    add_mesh(writer, mesh.view(), validation);
    writer.add("companions", std::span<const char>(section));
    writer.write(path);
}

}  // namespace

TEST_CASE("another source or another recipe has another place, another name of the source has not", "[unit]") {
    const Environment environment;
    const test::Scratch folder;
    ::setenv("ORBWEAVER_CACHE", folder.path("cache").c_str(), 1);
    const std::string source = folder.write("a.obj", "v 0 0 0\n");
    const std::string path = cached_path(source, {});
    CHECK(cached_path(folder.write("b.obj", "v 0 0 0\n"), {}) == path);
    CHECK(cached_path(folder.write("b.obj", "v 0 0 1\n"), {}) != path);
    CHECK(cached_path(source, {1e-9, {}}) != path);
    CHECK(cached_path(source, {0, {{"glass", {}}}}) != path);
    CHECK(cached_path(source, {0, {{"glass", {}}}}) != cached_path(source, {0, {{"glass", {0.1, 1, 0}}}}));
}

TEST_CASE("a mesh is found once it is baked, until a companion of its source changes", "[unit]") {
    const Environment environment;
    const test::Scratch folder;
    ::setenv("ORBWEAVER_CACHE", folder.path("cache").c_str(), 1);
    const std::string source = folder.write("m.gltf", "source");
    CHECK_FALSE(find_cached(source, {}));
    CHECK_THROWS_WITH(open_mesh(source),
                      source +
                          ": is not baked yet; run orbweaver-assets bake with this scene, or bake it "
                          "with orbweaver-assets adjacency and name the baked file");
    const Companion companion{"m.bin", hash_file(folder.write("m.bin", "points"))};
    std::filesystem::create_directory(folder.path("cache"));
    bake_into(cached_path(source, {}), std::span(&companion, 1));
    REQUIRE(find_cached(source, {}));
    CHECK(mesh_in(open_mesh(source)).triangles.size() == 12);
    folder.write("m.bin", "other points");
    CHECK_FALSE(find_cached(source, {}));
    std::filesystem::remove(folder.path("m.bin"));
    CHECK_FALSE(find_cached(source, {}));
    folder.write("m.bin", "points");
    CHECK(find_cached(source, {}));
}

TEST_CASE("a baked file is opened as it is, a damaged one in the cache is as good as none", "[unit]") {
    const Environment environment;
    const test::Scratch folder;
    ::setenv("ORBWEAVER_CACHE", folder.path("").c_str(), 1);
    bake_into(folder.path("m.baked"));
    CHECK(mesh_in(open_mesh(folder.path("m.baked"))).triangles.size() == 12);
    const std::string source = folder.write("m.obj", "source");
    std::filesystem::copy(folder.path("m.baked"), cached_path(source, {}));
    CHECK(find_cached(source, {}));
    std::filesystem::resize_file(cached_path(source, {}), 1000);
    CHECK_FALSE(find_cached(source, {}));
}
