#include "walker.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::surface {

using mesh::across_edge;
using mesh::across_triangle;
using mesh::next_corner;
using mesh::SurfaceMesh;

namespace {

/// Weights below this make an edge's end a vertex: a hundred times the rounding of a crossing near it.
constexpr double kAtVertex = 1e-13;

constexpr std::uint32_t third_corner(std::uint32_t edge) noexcept { return next_corner(next_corner(edge)); }

/// Turning from face 1 to face 2 about their edge, through the air above face 1: a number that grows with the
/// angle, from 0 to 4.
double turn_between(const Vec3& into1, const Vec3& up1, const Vec3& into2) noexcept {
    const double x = dot(into2, into1);
    return dot(into2, up1) >= 0 ? 1 - x : 3 + x;
}

FaceEdge first_of_fan(const SurfaceMesh& mesh, const FaceEdge& from) noexcept {
    const Vec3 into = into_face(mesh, from.face, from.edge);
    const Vec3 up = from.side * face_normal(triangles_of(mesh), from.face);
    FaceEdge first;
    double least = 5;
    for (const std::uint32_t each : mesh::fan_at(mesh, from.face, from.edge)) {
        const FaceEdge other{each / 4, each % 4, 1};
        if (other.face == from.face) continue;
        const double turn = turn_between(into, up, into_face(mesh, other.face, other.edge));
        if (turn >= least) continue;
        least = turn;
        first = other;
    }
    if (first.face == kNoFace) return first;
    const Vec3 into2 = into_face(mesh, first.face, first.edge);
    const Vec3 back =
        dot(into2, up) * into - dot(into2, into) * up;  // against the turn: into the air just swept
    if (dot(face_normal(triangles_of(mesh), first.face), back) < 0) first.side = -1;
    return first;
}

/// How each weight changes per metre along `d`: gradient of weight i = n x (edge opposite to i) / n^2.
std::array<double, 3> rates_along(const std::array<Vec3, 3>& p, const Vec3& d) noexcept {
    const Vec3 n = area_normal(p);
    const Vec3 across = cross(d, n) / dot(n, n);
    return {dot(across, p[2] - p[1]), dot(across, p[0] - p[2]), dot(across, p[1] - p[0])};
}

void normalize(std::array<double, 3>& weights) noexcept {
    double sum = 0;
    for (double& w : weights) sum += w = std::max(w, 0.0);
    for (double& w : weights) w /= sum;
}

}  // namespace

Vec3 into_face(const SurfaceMesh& mesh, std::uint32_t face, std::uint32_t edge) noexcept {
    const auto p = triangles_of(mesh).corners(face);
    const Vec3 along = unit(p[next_corner(edge)] - p[edge]);
    const Vec3 to_third = unit(p[third_corner(edge)] - p[edge]);
    return unit(to_third - dot(to_third, along) * along);
}

FaceEdge over_edge(const SurfaceMesh& mesh, const FaceEdge& from) noexcept {
    const std::uint32_t code = mesh.across[from.face][from.edge];
    if (code == mesh::kBorder) return {};
    if (code == mesh::kNonManifold) return first_of_fan(mesh, from);
    return {across_triangle(code), across_edge(code), mesh::is_flipped(code) ? -from.side : from.side};
}

Vec3 in_plane(const SurfaceMesh& mesh, std::uint32_t face, const Vec3& direction) noexcept {
    const Vec3 normal = face_normal(triangles_of(mesh), face);
    const Vec3 flat = direction - dot(direction, normal) * normal;
    const double length = norm(flat);
    constexpr double kUpright = 1e-12;  // of the direction's length: what is left is rounding
    return length > kUpright * norm(direction) ? flat / length : Vec3{};
}

Walker::Walker(const SurfaceMesh& mesh, const SurfacePoint& at, int side, const Vec3& direction) noexcept
    : mesh_(mesh), at_(at), side_(side), direction_(direction) {
    normalize(at_.weights);
}

void Walker::jump(const SurfacePoint& at, int side, const Vec3& direction) noexcept {
    at_ = at;
    side_ = side;
    direction_ = direction;
    normalize(at_.weights);
}

Walker::Met Walker::advance(double length) noexcept {
    const auto rates = rates_along(triangles_of(mesh_).corners(at_.face), direction_);
    auto& w = at_.weights;
    advanced_ = length;
    met_ = Met::nothing;
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (!(rates[i] < 0)) continue;
        const double reach = w[i] / -rates[i];
        if (reach >= advanced_) continue;
        advanced_ = reach;
        met_ = Met::edge;
        corner_ = i;
    }
    for (std::size_t i = 0; i < 3; ++i) w[i] += advanced_ * rates[i];
    if (met_ == Met::edge) w[corner_] = 0;
    normalize(w);
    if (met_ == Met::nothing) return met_;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t j = next_corner(i), k = next_corner(j);
        if (w[j] > kAtVertex || w[k] > kAtVertex) continue;
        w[i] = 1, w[j] = 0, w[k] = 0;
        // From within the face the vertex is turned at; a line that only begins beside the face goes over its
        // edge.
        if (rates[j] <= 0 && rates[k] <= 0) {
            met_ = Met::vertex;
            corner_ = i;
        } else {
            corner_ = rates[j] < 0 ? j : k;
        }
        break;
    }
    return met_;
}

bool Walker::cross() noexcept { return met_ == Met::vertex ? cross_vertex() : cross_edge(); }

bool Walker::cross_edge() noexcept {
    const std::uint32_t edge = next_corner(corner_);
    const FaceEdge next = over_edge(mesh_, {at_.face, edge, side_});
    if (next.face == kNoFace) return false;
    const auto& from = mesh_.triangles[at_.face];
    const auto& to = mesh_.triangles[next.face];
    const Vec3 along = unit(mesh_.vertices[from[next_corner(edge)]] - mesh_.vertices[from[edge]]);
    const double ahead = std::max(0.0, -dot(direction_, into_face(mesh_, at_.face, edge)));
    direction_ = unit(dot(direction_, along) * along + ahead * into_face(mesh_, next.face, next.edge));
    const bool same_way = to[next.edge] == from[edge];
    const double begin = at_.weights[edge], end = at_.weights[next_corner(edge)];
    std::array<double, 3> weights{};
    weights[next.edge] = same_way ? begin : end;
    weights[next_corner(next.edge)] = same_way ? end : begin;
    at_ = {next.face, weights};
    side_ = next.side;
    return true;
}

bool Walker::cross_vertex() noexcept {
    const VertexTurn turn = turn_at_vertex(mesh_, at_.face, corner_, side_, direction_);
    if (turn.face == kNoFace) return false;
    std::array<double, 3> weights{};
    weights[turn.corner] = 1;
    at_ = {turn.face, weights};
    side_ = turn.side;
    direction_ = turn.direction;
    return true;
}

}  // namespace orbweaver::surface
