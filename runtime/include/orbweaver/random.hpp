#pragma once

#include <cstdint>
#include <string_view>

namespace orbweaver {

/// A named stream of random numbers: the n-th number is a pure function of (seed, name, n), so a stream
/// needs no place in a snapshot unless its owner keeps a counter that moves with time.
/// SplitMix64 (Steele, Lea, Flood 2014) over a 64-bit key; no libm, the same bits everywhere.
class RandomStream {
public:
    RandomStream(std::uint64_t seed, std::string_view name) noexcept;

    std::uint64_t bits(std::uint64_t n) const noexcept;
    /// Uniform in [0, 1), 53 bits.
    double uniform(std::uint64_t n) const noexcept;
    /// Uniform in [low, high).
    double uniform(std::uint64_t n, double low, double high) const noexcept;

private:
    std::uint64_t key_;
};

}  // namespace orbweaver
