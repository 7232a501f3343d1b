#pragma once

#include <span>
#include <string_view>

#include "raw_mesh.hpp"

namespace orbweaver::mesh {

/// Meshes of our own. `size` is the largest extent (m; of a Moebius strip the circle about it), `subdivision`
/// how many pieces an edge is cut into; y is up. Each has one material, named after the shape, and is the same
/// bits everywhere.

RawMesh cube(double size, std::uint32_t subdivision);    ///< 6 n^2 quads about the origin
RawMesh room(double size, std::uint32_t subdivision);    ///< the inside of that cube: it is seen from within
RawMesh sphere(double size, std::uint32_t subdivision);  ///< 4 n meridians, 2 n bands; triangles at the poles
RawMesh height_field(double size,
                     std::uint32_t subdivision);  ///< n^2 quads over the xz plane: hills a tenth as high
RawMesh cliff(double size,
              std::uint32_t subdivision);  ///< ground, a wall that leans out over it, the plateau above
RawMesh torus(double size,
              std::uint32_t subdivision);  ///< about y, 4 n by 2 n quads; the tube a quarter as thick
RawMesh branch(double size,
               std::uint32_t subdivision);  ///< a bent tapering stem: quads, closed by a polygon at each end
RawMesh moebius_strip(double size,
                      std::uint32_t subdivision);  ///< 8 n by n quads with half a twist: one side, one border
RawMesh fan(double size,
            std::uint32_t subdivision);  ///< three blades of n^2 quads that meet in one line along y
RawMesh bow_tie(double size, std::uint32_t subdivision);  ///< two triangles of n^2 each that touch in one point
RawMesh t_junction(double size,
                   std::uint32_t subdivision);  ///< n^2 quads beside (2 n)^2 half as wide: corners on edges

struct Shape {
    std::string_view name;
    std::string_view meaning;
    RawMesh (*make)(double size, std::uint32_t subdivision);
};

/// All of them, by name.
std::span<const Shape> shapes() noexcept;

/// Scaled about the origin, then moved.
RawMesh transformed(RawMesh raw, double scale, const Vec3& offset);

}  // namespace orbweaver::mesh
