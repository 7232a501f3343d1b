#include "validation.hpp"

namespace orbweaver::mesh {

namespace {

/// Goes round a vertex from triangle to triangle; each and each fan is seen once, so that this takes linear
/// time.
class RingWalk {
public:
    explicit RingWalk(const SurfaceMesh& mesh)
        : mesh_(mesh), triangle_seen_at_(mesh.triangles.size(), kNone), fan_seen_at_(mesh.fan.size(), kNone) {}

    /// How many of a vertex's triangles can be reached from the first one.
    std::size_t reach(std::uint32_t vertex) {
        std::size_t reached = 0;
        visit(ring_at(mesh_, vertex)[0], vertex);
        while (!waiting_.empty()) {
            const std::uint32_t triangle = waiting_.back();
            waiting_.pop_back();
            ++reached;
            for (std::uint32_t edge = 0; edge < 3; ++edge) {
                const Triangle& corners = mesh_.triangles[triangle];
                if (corners[edge] == vertex || corners[next_corner(edge)] == vertex)
                    cross(triangle, edge, vertex);
            }
        }
        return reached;
    }

private:
    void cross(std::uint32_t triangle, std::uint32_t edge, std::uint32_t vertex) {
        const std::uint32_t code = mesh_.across[triangle][edge];
        if (is_neighbour(code)) return visit(across_triangle(code), vertex);
        if (code != kNonManifold) return;
        const auto faces = fan_at(mesh_, triangle, edge);
        std::uint32_t& seen_at = fan_seen_at_[static_cast<std::size_t>(faces.data() - mesh_.fan.data())];
        if (seen_at == vertex) return;
        seen_at = vertex;
        for (const std::uint32_t face : faces) visit(face / 4, vertex);
    }

    void visit(std::uint32_t triangle, std::uint32_t vertex) {
        if (triangle_seen_at_[triangle] == vertex) return;
        triangle_seen_at_[triangle] = vertex;
        waiting_.push_back(triangle);
    }

    const SurfaceMesh& mesh_;
    std::vector<std::uint32_t> triangle_seen_at_;
    std::vector<std::uint32_t> fan_seen_at_;
    std::vector<std::uint32_t> waiting_;
};

}  // namespace

void find_nonmanifold_vertices(const SurfaceMesh& mesh, Validation& into) {
    RingWalk walk(mesh);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        if (walk.reach(v) == ring_at(mesh, v).size()) continue;
        if (into.nonmanifold_vertices++ == 0) into.first_nonmanifold_vertex = v;
    }
}

}  // namespace orbweaver::mesh
