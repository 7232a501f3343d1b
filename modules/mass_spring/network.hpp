#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// A damped Hookean spring between particles a and b (thesis 4.14):
/// f_a = -[k (|l| - r) + c (dl/dt . l)/|l|] l/|l|,  l = x_a - x_b,  f_b = -f_a.
struct Spring {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double rest_length = 0;  ///< r, m, >= 0
    double stiffness = 0;    ///< k, N/m, >= 0
    double damping = 0;      ///< c, N s/m, >= 0
};

/// What does not change during a run: the model. Positions and velocities are state and live elsewhere.
struct Network {
    std::vector<double> mass;         ///< kg, > 0, one per particle
    std::vector<std::uint8_t> fixed;  ///< 1: the particle keeps its position
    std::vector<Spring> springs;

    std::size_t size() const noexcept { return mass.size(); }
};

/// A fault of a network, in words, with the element it lies in.
struct NetworkFault {
    enum class Element : std::uint8_t { network, particle, spring } element = Element::network;
    std::size_t index = 0;
    std::string sentence;
};

/// Every fault of a network at these positions: sizes that disagree, non-finite or non-positive masses,
/// indices out of range, a spring from a particle to itself, springs of no length (their direction is
/// undefined), negative or non-finite constants.
std::vector<NetworkFault> validate(const Network& network, std::span<const Vec3> positions);

/// The number of parts that no spring joins to each other; a sound web has one.
std::size_t count_parts(const Network& network);

}  // namespace orbweaver::mass_spring
