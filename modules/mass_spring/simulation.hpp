#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "adviser.hpp"
#include "energy_balance.hpp"
#include "integrator.hpp"
#include "method.hpp"
#include "run_error.hpp"
#include "simulation_settings.hpp"
#include "spring_system.hpp"
#include "watch.hpp"

namespace orbweaver::mass_spring {

/// Doubles that a simulation remembers between frames, besides x and v.
inline constexpr std::size_t kSimulationMemory = 2;
/// How often the stable step is looked up again while a system moves.
inline constexpr std::uint64_t kFramesPerAdvice = 64;

/// Advances one mass-spring system frame by frame: substeps as the method and the adviser ask, keeps the
/// last good state, watches for values that mean nothing and for energy from nowhere, and estimates its own
/// error by redoing sampled frames at half the step. Shared by every module whose bodies are mass-spring
/// systems.
class Simulation {
public:
    /// `memory` is kSimulationMemory doubles of the owner's state: the substep in use (s), which is chosen
    /// anew at every frame whose index is a multiple of kFramesPerAdvice, and the mark of the method that it
    /// was chosen for. When they are saved and restored with x and v, a restored run takes the substeps of the
    /// run that never stopped; by another method it chooses its own. Empty: kept here, and lost. `creep` is as
    /// many doubles of the owner's state as the network has springs where it has arms (m, see
    /// SpringSystem::get_creep()), which are put on at x. Another number: kept here, and lost.
    /// A step longer than a frame counts as one frame. Velocities of fixed particles are set to zero.
    /// Throws Fault(invalid) when a tolerance is asked of a network with arms or an undamped method of a
    /// network that is damped, and Fault(diverged) when
    /// on_unstable is `stop` and the asked step exceeds the advice, when no step is stable, or when a frame
    /// would need more than max_substeps.
    Simulation(SpringSystem& system, SimulationSettings settings, double frame_step, std::span<Vec3> x,
               std::span<Vec3> v, std::span<double> memory = {}, std::span<double> creep = {});
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation() = default;

    /// From `time` to `time` + frame_step. On the first value that is not finite, or position that left for
    /// 1e6 times the system's extent, restores the frame's start in x and v and throws Fault(diverged)
    /// naming element, term, time and step. A frame that gains as much energy as moves in it came to
    /// need a shorter step than was advised: `substep` redoes it at one that is stable in every arrangement
    /// (see bound_step()) and keeps that until the next advice, `stop` throws, `as_asked` warns. Throws like
    /// the constructor, with x and v untouched, when the configuration has come to need shorter steps than the
    /// settings allow.
    ///
    /// Throws Fault(diverged) where steps that the method divides come to more than max_substeps, and
    /// Fault(stopped) soon after settings.stop_asked says so, in both cases with the frame's start in x and v.
    ///
    /// Within a tolerance, the method chooses its steps, the first by the advice, and refuses those that err.
    /// Throws Fault(diverged) where no step errs little enough, or a frame would take more than max_substeps.
    void advance(std::uint64_t frame, double time);

    /// Between frames, after springs of the network were added, removed, cut or given other constants (see
    /// SpringSystem::network_changed()): the step is chosen anew at once. Arms go on from where they were where
    /// the springs are as many, and bear nothing where not. Throws like the constructor.
    void network_changed();

    const Advice& advice() const noexcept;
    std::uint64_t steps() const noexcept;  ///< and parts of them, error estimation not counted
    double substep() const noexcept;       ///< s, in use now
    /// Largest position error expected at the run's end, m: what the steps' own estimates add up to within a
    /// tolerance; else order-aware step doubling on sampled frames, or what the method's judge makes of them,
    /// each standing for those since the one before, and what vibrations did that were lost (see
    /// LostVibrations). Not a bound where the system itself is chaotic.
    double error_estimate() const noexcept { return error_.estimate(); }
    std::string error_method() const { return error_.how(); }           ///< how, over how many frames
    double error_seconds() const noexcept { return error_.seconds(); }  ///< wall time that the estimate took
    /// J that came from nowhere, summed over the frames that gained.
    double energy_gain() const noexcept;
    std::size_t memory_bytes() const noexcept;

private:
    void check_damping() const;
    void put_on_arms();
    void look();
    void choose_first_step();
    void choose_substep();
    void advance_within_tolerance(std::uint64_t frame, double time);
    void advance_in_equal_steps(std::uint64_t frame, double time);
    void set_substep(double seconds) noexcept;
    std::int64_t substeps_per_frame() const noexcept;
    /// As many steps as plan; false when it could not be finished. The balance is of the whole frame.
    bool run_frame(std::uint64_t frame, double time, EnergyBalance& balance);
    /// Whether there is a step that is stable in every arrangement.
    bool is_bounded() const noexcept;
    /// Whether energy from nowhere could be the step's doing.
    bool may_be_unstable() const noexcept;
    /// Whether energy from nowhere is no instability, but what a sweep over the springs left undone.
    bool leaves_springs_unmet() const noexcept;
    bool redo_shorter(std::uint64_t frame, double time, bool finished, EnergyBalance& balance);
    /// What on_unstable says of a frame that can be no motion, run at steps that may be too long.
    bool answer_instability(std::uint64_t frame, double time, bool finished, EnergyBalance& balance);
    void warn_of_gain(const std::string& sentence);
    void restore_start() noexcept;
    FrameRun frame_run(std::uint64_t index, std::int64_t steps, const EnergyBalance& balance) const;
    [[noreturn]] void stop(std::uint64_t frame, double time);
    [[noreturn]] void refuse_parts(std::uint64_t frame, double time);
    [[noreturn]] void fail(std::uint64_t frame, double time);

    SpringSystem* system_;
    SimulationSettings settings_;
    double frame_step_;
    std::span<Vec3> x_, v_;
    std::array<double, kSimulationMemory> own_memory_{};
    std::span<double> memory_;
    std::vector<double> own_creep_;
    std::span<double> creep_;  ///< m, at the frame's start
    Energy start_energy_;
    Integrator integrator_;
    Watch watch_;
    RunError error_;
    Advice advice_;
    bool advice_holds_ = false;  ///< for the positions that the first frame starts from
    double bound_step_ = 0;      ///< s, stable in every arrangement
    bool warned_ = false;
    bool warned_of_gain_ = false;
    double energy_gain_ = 0;
    std::uint64_t steps_ = 0;
    std::int64_t frame_steps_ = 0;         ///< that the frame took when it was last run, parts of steps counted
    std::vector<Vec3> start_x_, start_v_;  ///< the last good state
    std::vector<double> end_creep_;        ///< m, while a frame is redone
};

}  // namespace orbweaver::mass_spring
