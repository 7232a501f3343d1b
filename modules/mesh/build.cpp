#include "build.hpp"

#include <algorithm>
#include <limits>

#include "adjacency.hpp"
#include "buckets.hpp"
#include "orbweaver/fault.hpp"
#include "shells.hpp"
#include "t_junctions.hpp"
#include "triangulate.hpp"
#include "weld.hpp"

namespace orbweaver::mesh {

namespace {

/// Height over length below which a triangle has no direction: rounding alone turns its normal.
constexpr double kThinnest = 1e-14;

/// Triangles over the raw mesh's points, and the polygon each is part of.
struct Cut {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> polygon;
};

Cut cut_polygons(const RawMesh& raw, const std::vector<std::uint32_t>& welded, const std::string& name) try {
    Cut cut;
    cut.triangles.reserve(raw.corners.size() - 2 * raw.polygon_count());
    std::vector<std::uint32_t> polygon;
    for (std::uint32_t p = 0; p < raw.polygon_count(); ++p) {
        polygon.clear();
        for (std::uint32_t c = raw.first[p]; c < raw.first[p + 1]; ++c)
            polygon.push_back(welded[raw.corners[c]]);
        triangulate(raw.points, polygon, cut.triangles);
        cut.polygon.resize(cut.triangles.size(), p);
    }
    return cut;
} catch (const Fault& fault) {
    throw Fault(fault.kind(), name + ": " + fault.what());
}

bool is_degenerate(const RawMesh& raw, const Triangle& t) noexcept {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    const Vec3 ab = raw.points[t[1]] - raw.points[t[0]];
    const Vec3 bc = raw.points[t[2]] - raw.points[t[1]];
    const Vec3 ca = raw.points[t[0]] - raw.points[t[2]];
    return !(norm(cross(ab, bc)) > kThinnest * std::max({dot(ab, ab), dot(bc, bc), dot(ca, ca)}));
}

/// For each triangle, whether one before it has the same three vertices.
std::vector<std::uint8_t> find_duplicates(const std::vector<Triangle>& triangles, std::size_t points) {
    std::vector<Triangle> sorted = triangles;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    Buckets by_lowest =
        sort_into_buckets(static_cast<std::uint32_t>(sorted.size()), static_cast<std::uint32_t>(points),
                          [&](std::uint32_t t) { return sorted[t][0]; });
    std::vector<std::uint8_t> is_duplicate(sorted.size());
    const auto items = by_lowest.items.begin();
    for (std::size_t p = 0; p < points; ++p) {
        const auto begin = items + by_lowest.first[p];
        const auto end = items + by_lowest.first[p + 1];
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b;
        });
        for (auto i = begin; i != end && i + 1 != end; ++i)
            if (sorted[*i] == sorted[*(i + 1)]) is_duplicate[*(i + 1)] = 1;
    }
    return is_duplicate;
}

template <class IsDropped>
void drop(Cut& cut, std::uint64_t& count, std::uint32_t& first, IsDropped&& is_dropped) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
        if (is_dropped(t)) {
            if (count++ == 0) first = cut.polygon[t];
            continue;
        }
        cut.triangles[kept] = cut.triangles[t];
        cut.polygon[kept++] = cut.polygon[t];
    }
    cut.triangles.resize(kept);
    cut.polygon.resize(kept);
}

/// Numbers vertices in the order in which triangles need them, so that neighbours lie near each other in
/// memory.
std::vector<Vec3> number_vertices(const RawMesh& raw, std::vector<Triangle>& triangles) {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> number(raw.points.size(), kNone);
    for (Triangle& triangle : triangles)
        for (std::uint32_t& corner : triangle) {
            if (number[corner] == kNone) {
                number[corner] = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(raw.points[corner]);
            }
            corner = number[corner];
        }
    return vertices;
}

std::uint32_t first_with(const std::vector<Triangle>& across, std::uint32_t code) {
    const auto found = std::find_if(across.begin(), across.end(), [&](const Triangle& codes) {
        return std::find(codes.begin(), codes.end(), code) != codes.end();
    });
    return found == across.end() ? kNone : static_cast<std::uint32_t>(found - across.begin());
}

Bounds bounds_of(const std::vector<Vec3>& vertices) {
    Bounds bounds{vertices.front(), vertices.front()};
    for (const Vec3& v : vertices) {
        bounds.min = {std::min(bounds.min.x, v.x), std::min(bounds.min.y, v.y), std::min(bounds.min.z, v.z)};
        bounds.max = {std::max(bounds.max.x, v.x), std::max(bounds.max.y, v.y), std::max(bounds.max.z, v.z)};
    }
    return bounds;
}

void set_properties(const RawMesh& raw, const Recipe& recipe, const std::string& name, SurfaceMeshData& mesh) {
    const auto& names = raw.material_names;
    if (names.size() > std::numeric_limits<std::uint16_t>::max())
        throw Fault(FaultKind::limit, name + ": the mesh has " + std::to_string(names.size()) +
                                          " materials; expected at most 65535, so merge some");
    for (const auto& [material, property] : recipe.properties)
        if (std::find(names.begin(), names.end(), material) == names.end()) {
            std::string known;
            for (const std::string& each : names) {
                known += known.empty() ? "'" : ", '";
                known += each;
                known += "'";
            }
            throw Fault(FaultKind::invalid,
                        name + ": there is no material '" + material + "'; expected one of " + known);
        }
    for (const std::string& each : names) {
        const auto given = recipe.properties.find(each);
        mesh.properties.push_back(given == recipe.properties.end() ? SurfaceProperty{} : given->second);
        mesh.material_names.insert(mesh.material_names.end(), each.begin(), each.end());
        mesh.material_names.push_back('\0');
    }
    for (const std::uint32_t polygon : mesh.polygon)
        mesh.property.push_back(static_cast<std::uint16_t>(raw.material[polygon]));
}

}  // namespace

SurfaceMeshData build_surface_mesh(const RawMesh& raw, const Recipe& recipe, const std::string& name,
                                   Validation& validation) {
    check(raw, name);
    validation = {};
    validation.source_points = raw.points.size();
    validation.source_polygons = raw.polygon_count();
    const auto welded = weld(raw.points, recipe.weld_tolerance);
    for (std::uint32_t i = 0; i < welded.size(); ++i) validation.welded_points += welded[i] != i;
    Cut cut = cut_polygons(raw, welded, name);
    drop(cut, validation.dropped_degenerate, validation.first_degenerate,
         [&](std::size_t t) { return is_degenerate(raw, cut.triangles[t]); });
    drop(cut, validation.dropped_duplicate, validation.first_duplicate,
         [is_duplicate = find_duplicates(cut.triangles, raw.points.size())](std::size_t t) {
             return is_duplicate[t] != 0;
         });
    if (cut.triangles.empty())
        throw Fault(FaultKind::invalid, name + ": no polygon of the mesh has an area; export it again");

    SurfaceMeshData mesh;
    mesh.vertices = number_vertices(raw, cut.triangles);
    mesh.triangles = std::move(cut.triangles);
    mesh.polygon = std::move(cut.polygon);
    validation.unused_points = raw.points.size() - validation.welded_points - mesh.vertices.size();
    set_properties(raw, recipe, name, mesh);
    join(mesh, validation);
    return mesh;
}

void join(SurfaceMeshData& mesh, Validation& validation) {
    Adjacency adjacency = build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.vertices.size()));
    Shells shells = find_shells(mesh.triangles, adjacency);
    validation.edges = adjacency.edges;
    validation.border_edges = adjacency.border_edges;
    validation.nonmanifold_edges = adjacency.nonmanifold_edges();
    validation.shells = shells.count;
    validation.one_sided_shells = shells.one_sided;
    validation.flipped = shells.flipped;
    validation.first_flipped = shells.first_flipped;
    mesh.across = std::move(adjacency.across);
    mesh.ring_first = std::move(adjacency.ring_first);
    mesh.ring = std::move(adjacency.ring);
    mesh.fan_first = std::move(adjacency.fan_first);
    mesh.fan = std::move(adjacency.fan);
    mesh.shell = std::move(shells.shell);
    mesh.bounds = bounds_of(mesh.vertices);
    validation.nonmanifold_vertices = 0;
    validation.first_nonmanifold_vertex = kNone;
    find_nonmanifold_vertices(mesh.view(), validation);
    find_t_junctions(mesh.view(), validation);
    validation.first_border = first_with(mesh.across, kBorder);
    validation.first_nonmanifold = first_with(mesh.across, kNonManifold);
}

}  // namespace orbweaver::mesh
