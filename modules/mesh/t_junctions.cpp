#include "t_junctions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace orbweaver::mesh {

namespace {

using Edge = std::array<std::uint32_t, 2>;

double coordinate(const Vec3& p, int axis) noexcept { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Vertices, to be found by boxes: a tree of three alternating axes (Bentley 1975), each part's middle one its
/// node.
class VertexTree {
public:
    VertexTree(const SurfaceMesh& mesh, std::vector<std::uint32_t> vertices)
        : mesh_(mesh), vertices_(std::move(vertices)) {
        sort(0, vertices_.size(), 0);
    }

    template <class Visit>
    void visit_within(const Bounds& box, Visit&& visit) const {
        search(box, 0, vertices_.size(), 0, visit);
    }

private:
    double at(std::size_t i, int axis) const { return coordinate(mesh_.vertices[vertices_[i]], axis); }

    void sort(std::size_t first, std::size_t end, int axis) {
        if (end - first < 2) return;
        const std::size_t middle = first + (end - first) / 2;
        const auto begin = vertices_.begin();
        std::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                         begin + static_cast<std::ptrdiff_t>(middle), begin + static_cast<std::ptrdiff_t>(end),
                         [&](std::uint32_t a, std::uint32_t b) {
                             return coordinate(mesh_.vertices[a], axis) < coordinate(mesh_.vertices[b], axis);
                         });
        sort(first, middle, (axis + 1) % 3);
        sort(middle + 1, end, (axis + 1) % 3);
    }

    template <class Visit>
    void search(const Bounds& box, std::size_t first, std::size_t end, int axis, Visit& visit) const {
        if (first == end) return;
        const std::size_t middle = first + (end - first) / 2;
        if (coordinate(box.min, axis) <= at(middle, axis)) search(box, first, middle, (axis + 1) % 3, visit);
        visit(vertices_[middle]);
        if (coordinate(box.max, axis) >= at(middle, axis)) search(box, middle + 1, end, (axis + 1) % 3, visit);
    }

    const SurfaceMesh& mesh_;
    std::vector<std::uint32_t> vertices_;
};

std::vector<Edge> border_edges(const SurfaceMesh& mesh) {
    std::vector<Edge> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t e = 0; e < 3; ++e)
            if (mesh.across[t][e] == kBorder)
                edges.push_back({mesh.triangles[t][e], mesh.triangles[t][next_corner(e)]});
    return edges;
}

double largest_coordinate(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace

void find_t_junctions(const SurfaceMesh& mesh, Validation& into) {
    into.t_junctions = 0;
    into.first_t_junction = kNone;
    const auto edges = border_edges(mesh);
    if (edges.empty()) return;
    std::vector<std::uint32_t> vertices;
    for (const Edge& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const VertexTree tree(mesh, std::move(vertices));
    std::vector<std::uint32_t> found;
    for (const Edge& edge : edges) {
        const Vec3 &a = mesh.vertices[edge[0]], &b = mesh.vertices[edge[1]];
        const Vec3 along = b - a;
        const double square = dot(along, along);
        constexpr double kPart = 1e-6, kSingle = 0x1p-23;
        const double near =
            kPart * std::sqrt(square) + kSingle * std::max(largest_coordinate(a), largest_coordinate(b));
        const Bounds box{{std::min(a.x, b.x) - near, std::min(a.y, b.y) - near, std::min(a.z, b.z) - near},
                         {std::max(a.x, b.x) + near, std::max(a.y, b.y) + near, std::max(a.z, b.z) + near}};
        tree.visit_within(box, [&](std::uint32_t vertex) {
            const Vec3 from = mesh.vertices[vertex] - a;
            const double part = dot(from, along) / square;
            const double end = near / std::sqrt(square);  // as near to an end as that it is the end
            if (vertex == edge[0] || vertex == edge[1] || part <= end || part >= 1 - end) return;
            if (norm(from - part * along) <= near) found.push_back(vertex);
        });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    into.t_junctions = found.size();
    if (!found.empty()) into.first_t_junction = found.front();
}

}  // namespace orbweaver::mesh
