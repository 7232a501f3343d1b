#include "adjacency.hpp"

#include <algorithm>

namespace orbweaver::mesh {

namespace {

/// An edge of a triangle, filed under the lower of its vertices.
struct HalfEdge {
    std::uint32_t higher;  ///< the other vertex
    std::uint32_t code;    ///< triangle * 8 + edge * 2 + whether it runs from higher to lower
};

bool precedes(const HalfEdge& a, const HalfEdge& b) noexcept {
    return a.higher != b.higher ? a.higher < b.higher : a.code < b.code;
}

void sort(std::span<HalfEdge> edges) {
    constexpr std::size_t kShort = 24;  // below it insertion is faster; above it would be quadratic
    if (edges.size() > kShort) return std::sort(edges.begin(), edges.end(), precedes);
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const HalfEdge edge = edges[i];
        std::size_t to = i;
        for (; to > 0 && precedes(edge, edges[to - 1]); --to) edges[to] = edges[to - 1];
        edges[to] = edge;
    }
}

/// Links the half-edges of one edge to each other.
void link(std::span<const HalfEdge> faces, Adjacency& into) {
    ++into.edges;
    const auto across = [&](const HalfEdge& half) -> std::uint32_t& {
        return into.across[across_triangle(half.code)][across_edge(half.code)];
    };
    if (faces.size() == 1) {
        ++into.border_edges;
    } else if (faces.size() == 2) {
        const bool flipped = is_flipped(faces[0].code) == is_flipped(faces[1].code);
        for (const auto& [from, to] : {std::pair{faces[0], faces[1]}, std::pair{faces[1], faces[0]}})
            across(from) = across_code(across_triangle(to.code), across_edge(to.code), flipped);
    } else {
        for (const HalfEdge& half : faces) {
            across(half) = kNonManifold;
            into.fan.push_back(half.code >> 1);
        }
        into.fan_first.push_back(static_cast<std::uint32_t>(into.fan.size()));
    }
}

void build_rings(std::span<const Triangle> triangles, std::uint32_t vertex_count, Adjacency& into) {
    into.ring_first.assign(std::size_t{vertex_count} + 1, 0);
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle) ++into.ring_first[vertex + 1];
    for (std::uint32_t v = 0; v < vertex_count; ++v) into.ring_first[v + 1] += into.ring_first[v];
    into.ring.resize(3 * triangles.size());
    std::vector<std::uint32_t> next(into.ring_first.begin(), into.ring_first.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t vertex : triangles[t]) into.ring[next[vertex]++] = t;
}

/// All half-edges by lower vertex; `first` says where each vertex's begin.
std::vector<HalfEdge> file_half_edges(std::span<const Triangle> triangles, std::vector<std::uint32_t>& first) {
    for (const Triangle& t : triangles)
        for (std::uint32_t e = 0; e < 3; ++e) ++first[std::min(t[e], t[next_corner(e)]) + 1];
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    std::vector<HalfEdge> halves(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::uint32_t e = 0; e < 3; ++e) {
            const auto [lower, higher] = std::minmax({triangles[i][e], triangles[i][next_corner(e)]});
            halves[next[lower]++] = {higher, across_code(i, e, triangles[i][e] == higher)};
        }
    return halves;
}

}  // namespace

Adjacency build_adjacency(std::span<const Triangle> triangles, std::uint32_t vertex_count) {
    Adjacency result;
    result.across.assign(triangles.size(), {kBorder, kBorder, kBorder});
    result.fan_first.push_back(0);
    build_rings(triangles, vertex_count, result);
    std::vector<std::uint32_t> first(std::size_t{vertex_count} + 1, 0);
    std::vector<HalfEdge> halves = file_half_edges(triangles, first);
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
        const std::span<HalfEdge> filed(halves.data() + first[v], first[v + 1] - first[v]);
        sort(filed);
        for (std::size_t begin = 0, end = 0; begin < filed.size(); begin = end) {
            while (end < filed.size() && filed[end].higher == filed[begin].higher) ++end;
            link(filed.subspan(begin, end - begin), result);
        }
    }
    return result;
}

}  // namespace orbweaver::mesh
