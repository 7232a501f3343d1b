#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// Of one spring at x: -df/dx is along n n^T + across I, and -df/dv is damping n n^T, with the signs + + - - of
/// its two ends.
struct SpringLink {
    std::uint32_t a, b;
    Vec3 n;              ///< l/|l|; zero where it has none, as all else then
    double along = 0;    ///< N/m, T' - T/|l|
    double across = 0;   ///< N/m, T/|l|
    double damping = 0;  ///< N s/m
};

/// Forces of a system linearised at x (m), found once: geometric part, drag and arms included.
class SpringTangent {
public:
    SpringTangent(const SpringSystem& system, std::span<const Vec3> x);

    /// out = -(wk df/dx + wc df/dv) u; zero rows and columns for fixed particles.
    void apply(double wk, double wc, std::span<const Vec3> u, std::span<Vec3> out) const noexcept;
    std::span<const SpringLink> links() const noexcept { return links_; }  ///< one a spring

private:
    const Network* network_;
    double drag_;  ///< N s/m
    std::vector<SpringLink> links_;
};

}  // namespace orbweaver::mass_spring
