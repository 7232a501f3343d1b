#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "network.hpp"
#include "packing.hpp"

namespace orbweaver::mass_spring {

/// A network as the kernels read it.
///
/// Along a thread, and from one radius of a web to the next, springs come in *runs*: spring by spring, both
/// ends move on to the next particle. A run is cut into *quads* of four springs, whose eight ends are two
/// unbroken stretches of memory; gaps are filled with springs of no stiffness. The force of a spring is kept
/// in a slot of its own, run after run with zeros between, so that the forces on a *block* of four
/// particles are unbroken stretches of slots too: no index is looked up per spring. Where the network's own
/// numbering of its particles makes no runs, `packing` has them in an order that does: whoever reads a plane
/// goes by it.
struct SpringTable {
    explicit SpringTable(const Network& network);

    /// Springs between the particles at places a + j and b + j, j = 0..3, a < b, with their forces in slots
    /// slot + j.
    struct Quad {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t slot = 0;
        std::array<double, Packing::kLanes> rest_length{};  ///< m
        std::array<double, Packing::kLanes> stiffness{};    ///< N/m; 0 where there is no spring
    };
    /// Where `incident` lists the stretches of slots that a block's particles are pulled by: those of which
    /// they are the ends a, then those of which they are the ends b.
    struct Block {
        std::uint32_t first = 0;
        std::uint32_t first_as_b = 0;
        std::uint32_t end = 0;
        std::uint32_t held = 0;  ///< bit j: particle j is fixed, or padding
    };

    /// Of a quad's springs, see MaterialLaw.
    struct Law {
        std::array<double, Packing::kLanes> softening{};        ///< 1/m
        std::array<double, Packing::kLanes> stiffening{};       ///< 1/m^2
        std::array<double, Packing::kLanes> arm{};              ///< N/m
        std::array<double, Packing::kLanes> relaxation_rate{};  ///< 1/s; 0 where there is no arm
    };

    Packing packing;
    std::vector<Quad> quads;
    std::vector<std::array<double, Packing::kLanes>> damping;  ///< N s/m, per quad; empty: no spring is damped
    std::vector<Law> laws;                                     ///< per quad; empty: no spring has one
    std::vector<std::uint32_t>
        place;  ///< of each spring, quad times four and lane; empty: none has an arm or is driven

    std::vector<Block> blocks;
    std::vector<std::uint32_t> incident;  ///< first slots of stretches of four
    std::vector<double> inverse_mass;     ///< 1/kg, per place; 0 for fixed ones and padding
    std::size_t slots = 0;                ///< vectors of pull, those between runs always zero

    std::size_t memory_bytes() const noexcept;
};

}  // namespace orbweaver::mass_spring
