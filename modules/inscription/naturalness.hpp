#pragma once

#include "orbweaver/contracts/inscriber.hpp"

namespace orbweaver::inscription {

/// What writing cost a web of its nature.
struct Naturalness {
    double silk_removed = 0;       ///< m, of threads as thick as others of their kind
    double silk_added = 0;         ///< m, the same
    double silk_share = 0;         ///< both, over the silk of the plain web
    double max_tension_ratio = 1;  ///< the largest tension of any thread over that of the plain web
    double tension_change = 0;     ///< N, the largest of a thread that stays whole
    double mean_shift = 0;         ///< m, of points of the plain web
    std::size_t new_slack = 0;     ///< threads that are slack, beyond those that were
    double spacing_distance = 0;   ///< see spacings(): Kolmogorov's, 0 to 1
};

/// What differs between a web at rest before and after a change. Points of the plain web keep their places.
Naturalness compare(const WebAtRest& plain, const WebChange& change, const WebAtRest& changed);

/// m, between neighboring turns of the spiral: along each radius, from each of its points that spiral threads
/// end at to the next; sorted.
std::vector<double> spacings(const WebAtRest& web);

/// The largest difference between two distribution functions (Kolmogorov and Smirnov), of sorted samples.
double kolmogorov_distance(std::span<const double> one, std::span<const double> other);

}  // namespace orbweaver::inscription
