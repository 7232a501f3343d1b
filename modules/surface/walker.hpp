#pragma once

#include <cstdint>

#include "orbweaver/contracts/surface.hpp"
#include "surface_mesh.hpp"
#include "triangle_set.hpp"

namespace orbweaver::surface {

inline TriangleSet triangles_of(const mesh::SurfaceMesh& mesh) noexcept {
    return {mesh.vertices, mesh.triangles};
}

/// An edge of a face, and the side of the face that somebody stands on.
struct FaceEdge {
    std::uint32_t face = kNoFace;
    std::uint32_t edge = 0;  ///< from corner `edge` to corner (edge + 1) % 3
    int side = 1;
};

/// The same edge as the next face has it, for somebody who stays on the surface and goes over the edge: the
/// neighbour, on the side that its winding says; of several faces the one that is met first when turning from
/// this face about the edge through the air above it. face = kNoFace at a border.
FaceEdge over_edge(const mesh::SurfaceMesh& mesh, const FaceEdge& from) noexcept;

/// Unit vector in the plane of a face, across one of its edges, into the face.
Vec3 into_face(const mesh::SurfaceMesh& mesh, std::uint32_t face, std::uint32_t edge) noexcept;

/// Where a straight line goes on behind a vertex: the direction that has as much angle on its left as on its
/// right (Polthier and Schmies 1998).
struct VertexTurn {
    std::uint32_t face = kNoFace;  ///< kNoFace: the vertex is on a border
    std::uint32_t corner = 0;      ///< the vertex, as a corner of that face
    int side = 1;
    Vec3 direction;  ///< unit
};

/// For somebody on `face` who arrives at its corner `corner` along `direction` (unit, in the face's plane and
/// from within it). Angles are compared and halved as unit complex numbers: square roots, no trigonometry.
VertexTurn turn_at_vertex(const mesh::SurfaceMesh& mesh, std::uint32_t face, std::uint32_t corner, int side,
                          const Vec3& direction) noexcept;

/// Somebody on a face, underway. The place is kept as weights of the face's corners, never as a position of its
/// own: there is nothing that could drift off the surface.
class Walker {
public:
    Walker(const mesh::SurfaceMesh& mesh, const SurfacePoint& at, int side, const Vec3& direction) noexcept;

    enum class Met : std::uint8_t { nothing, edge, vertex };
    /// Ahead by `length` (m), or to the rim of the face when that is nearer.
    Met advance(double length) noexcept;
    /// m of the last advance.
    double advanced() const noexcept { return advanced_; }
    /// Across what advance() met, the direction unfolded. False at a border: nothing has changed.
    bool cross() noexcept;
    /// Elsewhere: on another face.
    void jump(const SurfacePoint& at, int side, const Vec3& direction) noexcept;

    const SurfacePoint& at() const noexcept { return at_; }
    int side() const noexcept { return side_; }
    const Vec3& direction() const noexcept { return direction_; }
    Vec3 position() const noexcept { return position_of(triangles_of(mesh_), at_); }
    Vec3 up() const noexcept { return side_ * face_normal(triangles_of(mesh_), at_.face); }
    Footing footing() const noexcept { return {at_, side_, direction_, position(), up()}; }

private:
    bool cross_edge() noexcept;
    bool cross_vertex() noexcept;

    const mesh::SurfaceMesh& mesh_;
    SurfacePoint at_;
    int side_;
    Vec3 direction_;
    double advanced_ = 0;
    Met met_ = Met::nothing;
    std::uint32_t corner_ = 0;  // met an edge: the corner opposite to it; a vertex: that corner
};

/// `direction` without what stands out of the face's plane, made unit; zero when nothing is left.
Vec3 in_plane(const mesh::SurfaceMesh& mesh, std::uint32_t face, const Vec3& direction) noexcept;

}  // namespace orbweaver::surface
