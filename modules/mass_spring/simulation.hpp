#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "adviser.hpp"
#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// What to do when the asked step is longer than the adviser's.
enum class OnUnstable : std::uint8_t { substep, stop, as_asked };

struct SimulationSettings {
    const MethodInfo* method = nullptr;
    double step = 0;  ///< s, asked substep; 0: the adviser's
    OnUnstable on_unstable = OnUnstable::substep;
    std::int64_t max_substeps = 100000;  ///< of one frame; more is refused in words
    std::string owner;                                       ///< for sentences: "web"
    std::function<std::string(std::size_t)> describe_spring; ///< "spring 12 (radius, 3 to 7)"
    std::function<void(const std::string&)> warn;            ///< receives full sentences
};

/// Advances one mass-spring system frame by frame: substeps as the method and the adviser ask, keeps the
/// last good state, watches for values that mean nothing, and estimates its own error by redoing sampled
/// frames at half the step. Shared by every module whose bodies are mass-spring systems.
class Simulation {
public:
    /// Throws Fault(diverged) when on_unstable is `stop` and the asked step exceeds the advice, when no step
    /// is stable, or when a frame would need more than max_substeps.
    Simulation(SpringSystem& system, SimulationSettings settings, double frame_step,
               std::span<Vec3> x, std::span<Vec3> v);

    /// From `time` to `time` + frame_step. On the first value that is not finite, or position that left for
    /// 1e6 times the system's extent, restores the frame's start in x and v and throws Fault(diverged)
    /// naming owner, element, term, time and step.
    void advance(std::uint64_t frame, double time);

    const Advice& advice() const noexcept;
    std::uint64_t steps() const noexcept;        ///< of the method, error estimation not counted
    double substep() const noexcept;             ///< s, in use now
    /// Largest position error expected at the run's end, m: order-aware step doubling on sampled frames,
    /// mean per frame times frames run. Not a bound where the system itself is chaotic.
    double error_estimate() const noexcept;
    std::string error_method() const;            ///< how, over how many frames
    std::size_t memory_bytes() const noexcept;
};

}  // namespace orbweaver::mass_spring
