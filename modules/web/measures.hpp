#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "layout.hpp"
#include "mass_spring/network.hpp"

namespace orbweaver::web {

/// What holds for any network of threads.
struct ThreadMeasures {
    double silk_length = 0;         ///< m, of all threads as they are
    double total_mass = 0;          ///< kg
    double max_strain = 0;          ///< largest (|l| - r)/r of the springs with a rest length
    std::size_t slack_springs = 0;  ///< springs shorter than their rest length by more than 1e-12 of it
};

/// What an orb web is compared by. Directions are those of the web's plane; "quadrant" is the spoke nearest
/// to up, down and the two sides.
struct OrbMeasures {
    std::size_t radii = 0;
    double spiral_turns = 0;  ///< mean number of spiral crossings of a spoke
    double capture_area = 0;  ///< m^2, ellipse minus hub: pi (d_v/2)(d_h/2) - pi (H/2)^2
    double mesh_width = 0;    ///< m, mean over the quadrants of (r_out - r_in)/(n - 1)
    double asymmetry = 0;     ///< (low - up)/(low + up) of the capture area about the hub
};

ThreadMeasures measure_threads(const mass_spring::Network& network, std::span<const Vec3> positions);

/// d_v and d_h are the upright and level extents of the capture spiral, H the diameter of the circle inside
/// its innermost crossings (Herberstein & Tso 2000). Without a spiral only `radii` is set.
OrbMeasures measure_orb(const Layout& layout, std::span<const Vec3> positions);

/// m^2, of the polygon of the inner frame, in the web's plane.
double frame_area(const Layout& layout, std::span<const Vec3> positions);

/// N, the largest net force on a particle that is not fixed, of forces as SpringSystem::forces gives them.
double largest_residual(const mass_spring::Network& network, std::span<const Vec3> forces);

}  // namespace orbweaver::web
