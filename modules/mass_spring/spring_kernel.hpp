#pragma once

#include <array>
#include <cstddef>

#include "orbweaver/vec3.hpp"
#include "spring_table.hpp"

namespace orbweaver::mass_spring {

/// What one evaluation reads besides the table. Vectors per particle are packed (see Packing).
struct KernelInput {
    const double* x = nullptr;         ///< m
    const double* v = nullptr;         ///< m/s; null: of no motion
    const double* external = nullptr;  ///< N, or null
    const double* creep = nullptr;     ///< m, of arms, as table.place says; null: arms bear nothing
    Vec3 gravity;                      ///< m/s^2
    double drag = 0;                   ///< N s/m
};

/// Packed positions (m) and velocities (m/s) to be moved, see DynamicSystem::kick_and_drift().
struct KickAndDrift {
    double* x = nullptr;
    double* v = nullptr;
    double kick = 0;   ///< s
    double drift = 0;  ///< s
};

/// Of a quad of springs whose rest lengths go evenly from some to others.
struct DrivenQuad {
    std::array<double, Packing::kLanes> begin{};   ///< m
    std::array<double, Packing::kLanes> end{};     ///< m
    std::array<double, Packing::kLanes> length{};  ///< m, as the last step began
    std::array<double, Packing::kLanes> rate{};    ///< m/s, by which it grew then
};

/// J done on springs by making their rest lengths others, and J that damping took since the last step began.
struct DriveWork {
    double work = 0;
    double damping = 0;
};

/// The two passes of a force evaluation, over a range of quads, then of blocks. Every set of kernels
/// does the same operations in the same order on each element, so the bits are the same.
struct SpringKernels {
    /// Into each spring's slot, pull = [T + c (dl/dt . l)/|l|] l/|l| with l = x_a - x_b, for quads
    /// [begin, end); `pull` is three planes of table.slots, N. Ends at the same point have no direction:
    /// no force.
    void (*pulls)(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                  double* pull) noexcept;
    /// a = (pulls as end b - pulls as end a + external - drag v)/m + g for blocks [begin, end), packed; 0
    /// where fixed.
    void (*accelerations)(const SpringTable& table, const KernelInput& input, const double* pull,
                          std::size_t begin, std::size_t end, double* a) noexcept;
    /// Another second pass: the accelerations, drag left out, kick the particles of blocks [begin, end), which
    /// then drift under drag. Of pulls without motion.
    void (*kicks)(const SpringTable& table, const KernelInput& input, const double* pull,
                  const KickAndDrift& move, std::size_t begin, std::size_t end) noexcept;
    /// The dashpots of quads [begin, end) creep for h seconds at the lengths of x.
    void (*creep)(const SpringTable& table, const double* x, double h, std::size_t begin, std::size_t end,
                  double* creep) noexcept;
    /// The lengths and rates of quads [begin, end) become those at x and v of the input.
    void (*remember)(const SpringTable& table, DrivenQuad* driven, const KernelInput& input, std::size_t begin,
                     std::size_t end) noexcept;
    /// The rest lengths of quads [begin, end) become those at `share` of their path; work is told at lengths
    /// that are older by `lag` steps (see MethodInfo), damping of the way from what is remembered. Then
    /// remember(), and the pulls, as above. Of springs without laws.
    DriveWork (*drive)(SpringTable& table, DrivenQuad* driven, double share, double lag,
                       const KernelInput& input, std::size_t begin, std::size_t end, double* pull) noexcept;
};

/// For any machine.
const SpringKernels& plain_kernels() noexcept;
/// For AVX-512 or AVX2; null where the processor or the compiler has none.
const SpringKernels* wide_kernels() noexcept;
/// The fastest that this machine can run.
const SpringKernels& best_kernels() noexcept;

}  // namespace orbweaver::mass_spring
