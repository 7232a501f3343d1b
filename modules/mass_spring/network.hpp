#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// How a thread departs from Hooke's law. Stretched by e = |l| - r > 0 it bears k e (1 - a e + b e^2): it
/// softens, then stiffens. Beside it may lie a Maxwell element, a spring k1 behind a dashpot, which bears k1 (e
/// - q) while its dashpot creeps, dq/dt = (e - q)/tau: the two are a standard linear solid, whose cycles are
/// loops.
struct MaterialLaw {
    double softening = 0;        ///< a, 1/m, >= 0; see rises()
    double stiffening = 0;       ///< b, 1/m^2, >= 0
    double arm = 0;              ///< k1, N/m, >= 0; 0: no Maxwell element
    double relaxation_time = 0;  ///< tau, s, > 0 where there is an arm

    bool is_curved() const noexcept { return softening > 0 || stiffening > 0; }
    /// Whether more stretch always bears more.
    bool rises() const noexcept { return !is_curved() || softening * softening < 3 * stiffening; }
};

/// A damped spring between particles a and b (thesis 4.14):
/// f_a = -[T + c (dl/dt . l)/|l|] l/|l|,  l = x_a - x_b,  f_b = -f_a,
/// with the tension T = k (|l| - r) where no law says otherwise.
struct Spring {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double rest_length = 0;  ///< r, m, >= 0
    double stiffness = 0;    ///< k, N/m, >= 0
    double damping = 0;      ///< c, N s/m, >= 0
    MaterialLaw law{};
};

/// What does not change during a run: the model. Positions and velocities are state and live elsewhere.
struct Network {
    std::vector<double> mass;         ///< kg, > 0, one per particle
    std::vector<std::uint8_t> fixed;  ///< 1: the particle keeps its position
    std::vector<Spring> springs;
    bool driven = false;  ///< rest lengths change as time goes on (see SpringSystem::drive()); particles are
                          ///< then packed as they are numbered

    std::size_t size() const noexcept { return mass.size(); }
};

/// Whether any of its springs has a curve, an arm, or damping.
bool is_curved(const Network& network) noexcept;
bool has_arms(const Network& network) noexcept;
bool is_damped(const Network& network) noexcept;

/// A fault of a network, in words, with the element it lies in.
struct NetworkFault {
    enum class Element : std::uint8_t { network, particle, spring } element = Element::network;
    std::size_t index = 0;
    std::string sentence;
};

/// Every fault of a network at these positions: sizes that disagree, non-finite or non-positive masses,
/// indices out of range, a spring from a particle to itself, springs of no length (their direction is
/// undefined), negative or non-finite constants, laws by which a thread would bear less when stretched more, or
/// whose arms have no time to relax in.
std::vector<NetworkFault> validate(const Network& network, std::span<const Vec3> positions);

/// The number of parts that no spring joins to each other; a sound web has one.
std::size_t count_parts(const Network& network);

}  // namespace orbweaver::mass_spring
