#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::study {

/// The positions of all of a subject's particles over time.
struct Motion {
    std::size_t particles = 0;
    double frame_s = 0;            ///< s between two rows
    std::vector<Vec3> positions;   ///< m, row by row; the first is before the first frame
    std::vector<double> energy_j;  ///< J at the end of each frame; empty when the module gives none

    std::size_t rows() const noexcept { return particles > 0 ? positions.size() / particles : 0; }
    std::span<const Vec3> row(std::size_t i) const noexcept {
        return {positions.data() + i * particles, particles};
    }
};

/// The largest distance of a particle between two motions, m, row by row, as far as both go.
std::vector<double> distances(const Motion& a, const Motion& b);
/// The largest of the first `rows` distances, m.
double distance(const Motion& a, const Motion& b, std::size_t rows);
/// The farthest that any particle gets from where it began, m.
double largest_displacement(const Motion& motion);
/// Root mean square of the particles' speed between rows, m/s: what a motion looks like, whatever its details.
double rms_speed(const Motion& motion);

}  // namespace orbweaver::study
