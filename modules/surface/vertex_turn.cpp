#include <algorithm>
#include <cmath>

#include "walker.hpp"

namespace orbweaver::surface {

using mesh::next_corner;
using mesh::SurfaceMesh;

namespace {

/// An angle in [0, pi] as a unit complex number.
struct Angle {
    double cos = 1;
    double sin = 0;

    bool at_most(const Angle& o) const noexcept { return cos >= o.cos; }
    Angle minus(const Angle& o) const noexcept {
        return {cos * o.cos + sin * o.sin, std::max(0.0, sin * o.cos - cos * o.sin)};
    }
    Angle half() const noexcept {
        return {std::sqrt(std::max(0.0, (1 + cos) / 2)), std::sqrt(std::max(0.0, (1 - cos) / 2))};
    }
};

Angle between(const Vec3& a, const Vec3& b) noexcept {
    const double c = dot(a, b), s = norm(cross(a, b));
    const double length = std::sqrt(c * c + s * s);
    return {c / length, s / length};
}

/// One of the two ways round a vertex: how far it has come, and what is left of the face it is in.
struct Front {
    std::uint32_t face;
    std::uint32_t corner;  // the vertex
    std::uint32_t edge;    // the one ahead; it ends at the vertex
    int side;
    Angle left;  // to that edge
};

/// The corner at an edge's other end.
std::uint32_t far_corner(const Front& front) noexcept {
    return front.edge == front.corner ? next_corner(front.edge) : front.edge;
}

Vec3 from_vertex(const SurfaceMesh& mesh, std::uint32_t face, std::uint32_t corner, std::uint32_t to) noexcept {
    return unit(mesh.corner(face, to) - mesh.corner(face, corner));
}

/// Over the edge ahead into the next face. False at a border.
bool go_on(const SurfaceMesh& mesh, Front& front) noexcept {
    const std::uint32_t vertex = mesh.triangles[front.face][front.corner];
    const FaceEdge next = over_edge(mesh, {front.face, front.edge, front.side});
    if (next.face == kNoFace) return false;
    const std::uint32_t corner =
        mesh.triangles[next.face][next.edge] == vertex ? next.edge : next_corner(next.edge);
    const std::uint32_t before =
        next_corner(next_corner(corner));  // edges at a corner: `corner` and the one before
    const std::uint32_t ahead = next.edge == corner ? before : corner;
    front = {next.face, corner, ahead, next.side, {}};
    front.left = between(from_vertex(mesh, next.face, corner, next_corner(corner)),
                         from_vertex(mesh, next.face, corner, before));
    return true;
}

/// The way out: in `front`'s face, by `angle` from the edge that it has just come over.
VertexTurn way_out(const SurfaceMesh& mesh, const Front& front, const Angle& angle) noexcept {
    const std::uint32_t j = next_corner(front.corner), k = next_corner(j);
    const std::uint32_t ahead = far_corner(front);
    const Vec3 edge = from_vertex(mesh, front.face, front.corner, ahead == j ? k : j);
    const Vec3 other = from_vertex(mesh, front.face, front.corner, ahead);
    const Vec3 across = unit(other - dot(other, edge) * edge);
    return {front.face, front.corner, front.side, unit(angle.cos * edge + angle.sin * across)};
}

}  // namespace

VertexTurn turn_at_vertex(const SurfaceMesh& mesh, std::uint32_t face, std::uint32_t corner, int side,
                          const Vec3& direction) noexcept {
    const Vec3 back = -direction;
    const std::uint32_t j = next_corner(corner), k = next_corner(j);
    Front fronts[2] = {{face, corner, corner, side, between(back, from_vertex(mesh, face, corner, j))},
                       {face, corner, k, side, between(back, from_vertex(mesh, face, corner, k))}};
    // Both go round by the same angle, the nearer edge first, until one comes into the face that the other is
    // in.
    const std::size_t most = 2 * mesh::ring_at(mesh, mesh.triangles[face][corner]).size() + 2;
    for (std::size_t i = 0; i < most; ++i) {
        const bool first = fronts[0].left.at_most(fronts[1].left);
        Front& mover = fronts[first ? 0 : 1];
        Front& other = fronts[first ? 1 : 0];
        other.left = other.left.minus(mover.left);
        if (!go_on(mesh, mover)) return {};
        if (mover.face == other.face) return way_out(mesh, mover, other.left.half());
    }
    return {};
}

}  // namespace orbweaver::surface
