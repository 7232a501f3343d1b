#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "network.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// A vector in a slot as wide as an AVX register; `w` carries nothing.
struct alignas(32) PaddedVec3 {
    double x = 0;
    double y = 0;
    double z = 0;
    double w = 0;
};

/// A network as the kernels read it: one array per constant, and for every particle its springs in order
/// of index. A spring's force lies in two slots, 2 i for its end b and 2 i + 1, negated, for its end a. Each
/// particle's list is filled up to whole groups with the slot behind the last spring's, which is always zero:
/// loops of one length are what the processor foresees, and adding +0 to a sum that began with +0 changes no
/// bit.
struct SpringTable {
    static constexpr std::uint32_t kGroup = 4;

    explicit SpringTable(const Network& network);

    std::vector<std::uint32_t> a;
    std::vector<std::uint32_t> b;
    std::vector<double> rest_length;  ///< m
    std::vector<double> stiffness;    ///< N/m
    std::vector<double> damping;      ///< N s/m
    bool damped = false;              ///< whether any spring is

    std::vector<std::uint32_t> first;     ///< of `incident`, per particle, and one more at the end
    std::vector<std::uint32_t> incident;  ///< slots, per particle
    std::vector<double> inverse_mass;     ///< 1/kg; 0 for fixed particles

    std::size_t springs() const noexcept { return a.size(); }
    std::size_t slots() const noexcept { return 2 * springs() + 1; }
    std::size_t particles() const noexcept { return inverse_mass.size(); }
    std::size_t memory_bytes() const noexcept;
};

/// What one evaluation reads besides the table.
struct KernelInput {
    const Vec3* x = nullptr;         ///< m
    const Vec3* v = nullptr;         ///< m/s
    const Vec3* external = nullptr;  ///< N, or null
    Vec3 gravity;                    ///< m/s^2
    double drag = 0;                 ///< N s/m
};

/// The two passes of a force evaluation over a range of springs, then of particles. Every set of kernels
/// does the same operations in the same order on each element, so the bits are the same.
struct SpringKernels {
    /// pull[2 i] = -pull[2 i + 1] = [k (|l| - r) + c (dl/dt . l)/|l|] l/|l| for springs [begin, end). Ends at
    /// the same point have no direction: no force.
    void (*pulls)(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                  PaddedVec3* pull) noexcept;
    /// a[i] = (sum of its springs + external - drag v)/m + g for particles [begin, end); 0 where fixed.
    void (*accelerations)(const SpringTable& table, const KernelInput& input, const PaddedVec3* pull,
                          std::size_t begin, std::size_t end, Vec3* a) noexcept;
};

/// Plain C++, for any machine.
const SpringKernels& plain_kernels() noexcept;
/// Four springs at a time; null where the processor or the compiler has no AVX2.
const SpringKernels* avx2_kernels() noexcept;
/// The fastest that this machine can run.
const SpringKernels& best_kernels() noexcept;

}  // namespace orbweaver::mass_spring
