#include "surface_mesh.hpp"

#include <algorithm>

namespace orbweaver::mesh {

namespace {

std::pair<std::uint32_t, std::uint32_t> ends_of(const SurfaceMesh& mesh, std::uint32_t triangle,
                                                std::uint32_t edge) {
    const Triangle& corners = mesh.triangles[triangle];
    return std::minmax(corners[edge], corners[next_corner(edge)]);
}

}  // namespace

std::span<const std::uint32_t> fan_at(const SurfaceMesh& mesh, std::uint32_t triangle,
                                      std::uint32_t edge) noexcept {
    if (mesh.across[triangle][edge] != kNonManifold) return {};
    const auto wanted = ends_of(mesh, triangle, edge);
    const auto fan_ends = [&](std::uint32_t begin) {
        return ends_of(mesh, mesh.fan[begin] / 4, mesh.fan[begin] % 4);
    };
    const auto firsts = mesh.fan_first.first(mesh.fan_first.size() - 1);
    const auto found =
        std::lower_bound(firsts.begin(), firsts.end(), wanted,
                         [&](std::uint32_t begin, const auto& ends) { return fan_ends(begin) < ends; });
    if (found == firsts.end()) return {};
    return mesh.fan.subspan(*found, *(found + 1) - *found);
}

std::string_view material_name(const SurfaceMesh& mesh, std::size_t property) noexcept {
    std::string_view rest(mesh.material_names.data(), mesh.material_names.size());
    for (; property > 0 && !rest.empty(); --property)
        rest.remove_prefix(std::min(rest.find('\0'), rest.size() - 1) + 1);
    return rest.substr(0, rest.find('\0'));
}

SurfaceMesh SurfaceMeshData::view() const noexcept {
    return {vertices, triangles, across,   ring_first, ring,           fan_first, fan,
            polygon,  shell,     property, properties, material_names, bounds};
}

}  // namespace orbweaver::mesh
