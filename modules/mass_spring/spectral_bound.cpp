#include "spectral_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "spring_force.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The largest eigenvalue of M^-1 times a weight's matrix, bounded for every arrangement. `drag` is the same
/// for all particles.
template <class Weight>
double bound_eigenvalue(const Network& network, const Weight& weight, double drag) {
    constexpr int kIterations = 50;
    const std::size_t n = network.size();
    std::vector<double> inverse_root(n);
    for (std::size_t i = 0; i < n; ++i)
        inverse_root[i] = network.fixed[i] != 0 ? 0 : 1 / std::sqrt(network.mass[i]);
    std::vector<double> q(n, 1), image(n);
    double bound = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kIterations; ++round) {
        for (std::size_t i = 0; i < n; ++i) image[i] = drag * inverse_root[i] * inverse_root[i] * q[i];
        for (const Spring& s : network.springs) {
            const double pair = inverse_root[s.a] * q[s.a] + inverse_root[s.b] * q[s.b];
            image[s.a] += weight(s) * inverse_root[s.a] * pair;
            image[s.b] += weight(s) * inverse_root[s.b] * pair;
        }
        double ratio = 0;
        double largest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            ratio = std::max(ratio, image[i] / q[i]);
            largest = std::max(largest, image[i]);
        }
        bound = std::min(bound, ratio);
        if (largest == 0) return 0;
        // Never zero, so that every particle keeps its say.
        for (std::size_t i = 0; i < n; ++i) q[i] = std::max(image[i] / largest, 1e-100);
    }
    return bound;
}

}  // namespace

SpectralBound bound_spectrum(const Network& network, double drag) {
    return {std::sqrt(bound_eigenvalue(network, largest_slope, 0)),
            bound_eigenvalue(
                network, [](const Spring& s) { return s.damping; }, drag)};
}

}  // namespace orbweaver::mass_spring
