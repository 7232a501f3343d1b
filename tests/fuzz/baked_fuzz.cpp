#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "baked/layout.hpp"
#include "mesh_file.hpp"
#include "orbweaver/fault.hpp"
#include "target_file.hpp"
#include "verify.hpp"

using namespace orbweaver;

namespace {

/// A file in memory, to be opened by its path.
class MemoryFile {
public:
    explicit MemoryFile(std::span<const std::byte> bytes) : descriptor_(::memfd_create("baked", MFD_CLOEXEC)) {
        if (::write(descriptor_, bytes.data(), bytes.size()) != std::ssize(bytes)) std::abort();
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

/// Size and checksum put right, so that what lies behind them is reached.
void seal(std::vector<std::byte>& bytes) {
    baked::Header header;
    std::memcpy(&header, bytes.data(), sizeof header);
    header.file_size = bytes.size();
    std::memcpy(bytes.data(), &header, sizeof header);
    header.checksum = baked::checksum(bytes);
    std::memcpy(bytes.data(), &header, sizeof header);
}

/// Everything that a reader follows must lead to something, once mesh_in has let it pass.
void walk(const mesh::SurfaceMesh& mesh) {
    double sum = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) {
            sum += mesh.corner(t, e).x + mesh.properties[mesh.property[t]].friction;
            if (const std::uint32_t code = mesh.across[t][e]; mesh::is_neighbour(code))
                sum += mesh.triangles[mesh::across_triangle(code)][mesh::across_edge(code)];
            for (const std::uint32_t face : mesh::fan_at(mesh, t, e)) sum += mesh.triangles[face / 4][face % 4];
            for (const std::uint32_t near : mesh::ring_at(mesh, mesh.triangles[t][e]))
                sum += mesh.triangles[near][0];
        }
    for (std::size_t i = 0; i < mesh.properties.size(); ++i) sum += mesh::material_name(mesh, i).size();
    volatile double keep = sum;
    static_cast<void>(keep);
}

void read_mesh(const std::string& path) {
    const BakedFile file(path, mesh::kMeshType, mesh::kMeshVersion);
    const mesh::SurfaceMesh mesh = mesh::mesh_in(file);
    walk(mesh);
    mesh::verify(mesh, mesh::validation_in(file), file.path());
}

void read_target(const std::string& path) {
    const BakedFile file(path, inscription::kTargetType, inscription::kTargetVersion);
    inscription::verify_target(file);
}

void read(std::span<const std::byte> bytes) {
    const MemoryFile memory(bytes);
    for (const auto& read_as : {read_mesh, read_target}) {
        try {
            read_as(memory.path());
        } catch (const Fault&) {
        }
    }
}

}  // namespace

// A file is refused with a Fault or can be walked without leaving it; anything else is a defect.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::byte> bytes(size);
    if (size > 0) std::memcpy(bytes.data(), data, size);
    read(bytes);
    if (size < sizeof(baked::Header)) return 0;
    seal(bytes);
    read(bytes);
    return 0;
}
