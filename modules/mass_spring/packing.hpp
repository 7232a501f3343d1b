#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// How methods and kernels see a vector per particle: all x, then all y, then all z, so that four neighbours
/// fill a register. Each plane is padded with zeros to a whole number of blocks of four, and far enough for a
/// block that begins at the last particle. Planes may have the particles in an order of their own.
class Packing {
public:
    static constexpr std::size_t kLanes = 4;

    explicit Packing(std::size_t particles) noexcept : particles_(particles) {}
    /// Particle i is at `place[i]` of each plane; each place has one.
    explicit Packing(std::vector<std::uint32_t> place) noexcept
        : particles_(place.size()), place_(std::move(place)) {}

    std::size_t particles() const noexcept { return particles_; }
    /// Doubles from a particle's x to its y, and from that to its z.
    std::size_t plane() const noexcept { return blocks() * kLanes; }
    std::size_t blocks() const noexcept { return (particles_ + 2 * (kLanes - 1)) / kLanes; }
    std::size_t length() const noexcept { return 3 * plane(); }  ///< doubles in all
    /// Of a particle, in each plane.
    std::size_t place(std::size_t particle) const noexcept {
        return place_.empty() ? particle : place_[particle];
    }
    std::size_t memory_bytes() const noexcept { return place_.capacity() * sizeof(std::uint32_t); }

    /// `packed` has length() doubles, whose padding is left as it is; `vectors` one per particle.
    void pack(std::span<const Vec3> vectors, std::span<double> packed) const noexcept;
    void unpack(std::span<const double> packed, std::span<Vec3> vectors) const noexcept;

private:
    std::size_t particles_;
    std::vector<std::uint32_t> place_;  ///< empty: as they are numbered
};

}  // namespace orbweaver::mass_spring
