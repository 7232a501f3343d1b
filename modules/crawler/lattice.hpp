#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mass_spring/network.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// A body at rest: a straight bar with a square cross-section, cut into cubes or nearly so.
struct Build {
    std::uint32_t segments = 20;  ///< at least 2
    double length = 0.1;          ///< m
    double width = 0.005;         ///< m, an edge of the cross-section
    double mass = 0.0025;         ///< kg
    double stiffness = 0;         ///< N/m, of every spring
    double damping = 0;           ///< N s/m, of every spring
    bool keeps_volume = true;     ///< rings grow where the body shortens

    double segment() const noexcept { return length / segments; }                 ///< m
    double point_mass() const noexcept { return mass / (4.0 * (segments + 1)); }  ///< kg, of each mass
};

/// Corners of a ring: right below is 1, and on they go against the clock for who looks along the body from the
/// tail. Of unit cross-section, by how much they are to the right and up.
inline constexpr std::uint32_t kCorners = 4;
inline constexpr std::array<double, kCorners> kRight{-0.5, 0.5, 0.5, -0.5};
inline constexpr std::array<double, kCorners> kUp{-0.5, -0.5, 0.5, 0.5};

/// Bodies as a lattice of masses (Miller 1988): each segment is a cube with springs along its edges and across
/// its faces. Body after body, ring after ring from the tail to the head, corner after corner.
struct Lattice {
    std::uint32_t bodies = 1;
    std::uint32_t segments = 2;  ///< of each

    /// Springs of a ring: its edges, by their first corner; two diagonals.
    static constexpr std::uint32_t kRingSprings = 6;
    /// Of a segment: its edges along the body; diagonals to the next corner; diagonals to the one before.
    static constexpr std::uint32_t kSegmentSprings = 12;

    std::uint32_t rings() const noexcept { return segments + 1; }
    std::size_t points_a_body() const noexcept { return std::size_t{kCorners} * rings(); }
    std::size_t points() const noexcept { return bodies * points_a_body(); }
    std::size_t point(std::uint32_t body, std::uint32_t ring) const noexcept {
        return body * points_a_body() + std::size_t{kCorners} * ring;
    }
    std::size_t springs_a_body() const noexcept {
        return std::size_t{kRingSprings} * rings() + std::size_t{kSegmentSprings} * segments;
    }
    /// First springs of a ring, and of the segment between it and the next, which follow those of the ring.
    std::size_t ring_spring(std::uint32_t body, std::uint32_t ring) const noexcept {
        return body * springs_a_body() + std::size_t{kRingSprings + kSegmentSprings} * ring;
    }
    std::size_t segment_spring(std::uint32_t body, std::uint32_t segment) const noexcept {
        return ring_spring(body, segment) + kRingSprings;
    }
};

/// Where a ring's middle is, and which way its body goes on from there. Unit vectors at right angles.
struct Pose {
    Vec3 middle;  ///< m
    Vec3 forward, up;
    Vec3 right() const noexcept { return cross(forward, up); }
};

/// As many bodies as there are poses, of their middles, driven springs at their lengths at rest. All masses
/// are alike.
mass_spring::Network make_network(const Lattice& lattice, const Build& build);
/// m, appended to `points`: the four of a ring.
void add_ring_points(const Pose& ring, double width, std::vector<Vec3>& points);
/// m, of all points of straight bodies.
std::vector<Vec3> straight_points(const Lattice& lattice, const Build& build, std::span<const Pose> poses);

/// m, of a ring of whose four points the first is given.
inline Vec3 ring_middle(const Vec3* points) noexcept {
    return 0.25 * (points[0] + points[1] + points[2] + points[3]);
}

/// m^3, within the surface of a body whose points are given; its faces are cut into triangles around their
/// middles.
double volume(const Lattice& lattice, std::span<const Vec3> points) noexcept;

}  // namespace orbweaver::crawler
