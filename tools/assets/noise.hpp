#pragma once

#include <cstdint>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// Smooth random values on a lattice of unit cells (value noise with quintic blending), in [0, 1].
class Noise {
public:
    explicit Noise(std::uint64_t seed) noexcept : seed_(seed) {}

    double value(const Vec3& p) const noexcept;
    /// Sum of octaves, each twice as fine and half as strong (fractional Brownian motion), in [0, 1], mean 1/2.
    double fractal(const Vec3& p, int octaves) const noexcept;

private:
    double corner(std::int64_t x, std::int64_t y, std::int64_t z) const noexcept;

    std::uint64_t seed_;
};

}  // namespace orbweaver
