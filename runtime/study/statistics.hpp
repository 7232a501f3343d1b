#pragma once

#include <cstddef>
#include <vector>

#include "study/motion.hpp"

namespace orbweaver::study {

/// What two motions can have in common though their details have parted.
struct Statistics {
    double mean_energy_j = 0;      ///< J, mean over all frames; not a number when the module gives none
    std::vector<Vec3> mean_shape;  ///< m, mean position of each particle
    double frequency_hz = 0;       ///< Hz, the strongest in the spectrum of the chosen particle
    double power_m2 = 0;           ///< m^2, its mean square distance from its mean position
};

/// How far statistics lie from those of the reference.
struct Deviation {
    double energy = 0;     ///< of the mean energy, relative
    double shape_m = 0;    ///< m, largest distance of the mean shapes
    double frequency = 0;  ///< of the strongest frequency, relative
    double power = 0;      ///< of the power, relative
};

/// The particle that moves most: with the largest mean square distance from its mean position.
std::size_t busiest_particle(const Motion& motion);

/// The spectrum is that of the particle's three coordinates about their means, summed:
/// P_k = sum_xyz |sum_n x_n e^(-2 pi i k n/N)|^2, of the last 4096 rows if there are more.
Statistics measure(const Motion& motion, std::size_t particle);

Deviation compare(const Statistics& found, const Statistics& reference);

}  // namespace orbweaver::study
