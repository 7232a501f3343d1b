#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "adjacency.hpp"
#include "bake_mesh.hpp"
#include "import_mesh.hpp"
#include "mesh_file.hpp"
#include "obj.hpp"
#include "shapes.hpp"
#include "shells.hpp"

using namespace orbweaver;

namespace {

namespace fs = std::filesystem;

/// A torus of 8 n^2 quads, hence 16 n^2 triangles: 1,000,000 of them.
constexpr std::uint32_t kMillion = 250;

const mesh::SurfaceMeshData& surface() {
    static const mesh::SurfaceMeshData built = [] {
        mesh::Validation validation;
        return mesh::build_surface_mesh(mesh::torus(1, kMillion), {}, "torus", validation);
    }();
    return built;
}

/// The torus as OBJ and as a baked file, in a folder that goes with the process.
class Files {
public:
    Files() {
        auto pattern = (fs::temp_directory_path() / "orbweaver-benchmark-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        std::ofstream(source(), std::ios::binary) << obj_text(mesh::torus(1, kMillion));
        bake_mesh(source(), {}, {}, baked());
    }
    ~Files() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    std::string source() const { return folder_ / "torus.obj"; }
    std::string baked() const { return folder_ / "torus.baked"; }

private:
    fs::path folder_;
};

const Files& files() {
    static const Files made;
    return made;
}

void adjacency(benchmark::State& state) {
    const auto vertices = static_cast<std::uint32_t>(surface().vertices.size());
    for (auto _ : state) benchmark::DoNotOptimize(mesh::build_adjacency(surface().triangles, vertices));
    state.counters["triangles"] = static_cast<double>(surface().triangles.size());
}

void shells(benchmark::State& state) {
    const auto vertices = static_cast<std::uint32_t>(surface().vertices.size());
    const mesh::Adjacency found = mesh::build_adjacency(surface().triangles, vertices);
    for (auto _ : state) benchmark::DoNotOptimize(mesh::find_shells(surface().triangles, found));
}

void build(benchmark::State& state) {
    const mesh::RawMesh raw = mesh::torus(1, kMillion);
    mesh::Validation validation;
    for (auto _ : state) benchmark::DoNotOptimize(mesh::build_surface_mesh(raw, {}, "torus", validation));
}

void import_and_build(benchmark::State& state) {
    mesh::Validation validation;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            mesh::build_surface_mesh(import_mesh(files().source(), {}).raw, {}, "torus", validation));
}

// Ready to be asked: mapped, its checksum and every index checked.
void open_baked(benchmark::State& state) {
    for (auto _ : state) {
        const BakedFile file(files().baked(), mesh::kMeshType, mesh::kMeshVersion);
        benchmark::DoNotOptimize(mesh::mesh_in(file).triangles.size());
    }
    state.counters["bytes"] = static_cast<double>(fs::file_size(files().baked()));
}

}  // namespace

BENCHMARK(adjacency)->Name("mesh/adjacency/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(shells)->Name("mesh/shells/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(build)->Name("mesh/build/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(import_and_build)->Name("mesh/import_and_build/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(open_baked)->Name("mesh/open_baked/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_MAIN();
