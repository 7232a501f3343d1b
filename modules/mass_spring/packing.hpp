#pragma once

#include <cstddef>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// How methods and kernels see a vector per particle: all x, then all y, then all z, so that four neighbours
/// fill a register. Each plane is padded with zeros to a whole number of blocks of four, and far enough for a
/// block that begins at the last particle.
class Packing {
public:
    static constexpr std::size_t kLanes = 4;

    explicit constexpr Packing(std::size_t particles) noexcept : particles_(particles) {}

    constexpr std::size_t particles() const noexcept { return particles_; }
    /// Doubles from a particle's x to its y, and from that to its z.
    constexpr std::size_t plane() const noexcept { return blocks() * kLanes; }
    constexpr std::size_t blocks() const noexcept { return (particles_ + 2 * (kLanes - 1)) / kLanes; }
    constexpr std::size_t length() const noexcept { return 3 * plane(); }  ///< doubles in all

    /// `packed` has length() doubles, whose padding is left as it is; `vectors` one per particle.
    void pack(std::span<const Vec3> vectors, std::span<double> packed) const noexcept;
    void unpack(std::span<const double> packed, std::span<Vec3> vectors) const noexcept;

private:
    std::size_t particles_;
};

}  // namespace orbweaver::mass_spring
