#pragma once

#include <cstddef>
#include <vector>

#include "study/motion.hpp"

namespace orbweaver::study {

/// What two motions can have in common though their details have parted.
struct Statistics {
    double mean_energy_j = 0;      ///< J, mean over all frames; not a number when the module gives none
    std::vector<Vec3> mean_shape;  ///< m, mean position of each particle
    double power_m2 = 0;           ///< m^2, mean square distance of the chosen particle from its mean position
    std::vector<double> spectrum;  ///< share of that power at each multiple of the lowest frequency
    double frequency_hz = 0;       ///< Hz, where that share is largest
};

/// How far statistics lie from those of the reference.
struct Deviation {
    double energy = 0;     ///< of the mean energy, relative; not a number when the module gives none
    double shape_m = 0;    ///< m, largest distance of the mean shapes
    double spectrum = 0;   ///< half the sum of |differences| of the spectra: 0 the same, 1 nothing in common
    double frequency = 0;  ///< of the strongest frequency, relative
    double power = 0;      ///< of the power, relative
};

/// The particle that moves most from row `first` on: with the largest mean square distance from its mean
/// position.
std::size_t busiest_particle(const Motion& motion, std::size_t first = 0);

/// Of the rows from `first` on. The spectrum is that of the particle's three coordinates about their means,
/// summed: P_k = sum_xyz |sum_n x_n e^(-2 pi i k n/N)|^2, of the last 4096 rows if there are more, divided by
/// the sum over k.
Statistics measure(const Motion& motion, std::size_t particle, std::size_t first = 0);

Deviation compare(const Statistics& found, const Statistics& reference);

/// The middle value, or the mean of the middle two; 0 of none.
double median(std::vector<double> values);

}  // namespace orbweaver::study
