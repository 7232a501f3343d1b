#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "energy_balance.hpp"
#include "error_meter.hpp"
#include "integrator.hpp"
#include "lost_vibrations.hpp"
#include "simulation_settings.hpp"
#include "spring_system.hpp"
#include "watch.hpp"

namespace orbweaver::mass_spring {

/// A frame as a run took it. Creeps (m) are empty where the network has no arms.
struct FrameRun {
    std::uint64_t index = 0;
    std::int64_t steps = 1;            ///< that it took
    std::span<const Vec3> start_x, x;  ///< m
    std::span<const Vec3> start_v, v;  ///< m/s
    std::span<const double> start_creep;
    Energy start_energy;
    EnergyBalance balance;
    double told_error = 0;  ///< m, that its steps' embedded errors add up to; 0: they tell none
};

/// Estimates what a run is off by: redoes sampled frames, and those that stand out, at half the step, or by the
/// method's judge, and once more with books of energy. The run itself stays as it is: what is here is no state.
class RunError {
public:
    /// Whose settings, system and integrator outlive it; x (m) is where the run begins.
    RunError(SpringSystem& system, const SimulationSettings& settings, Integrator& integrator,
             const Watch& watch, double frame_step, std::span<const Vec3> x);

    /// After every frame. `omega`: of the fastest vibration, rad/s. Leaves other creeps in the system.
    void add(const FrameRun& frame, double omega);
    /// The springs are others from here on.
    void network_changed() noexcept { followed_ = false; }

    double estimate() const noexcept;                     ///< m; NaN where no frame was redone
    std::string how() const;                              ///< and over how many frames
    double seconds() const noexcept { return seconds_; }  ///< wall time that it took
    std::size_t memory_bytes() const noexcept;

private:
    /// What tells a frame that errs more than others before it is redone.
    using Signs = std::array<double, 3>;
    Signs signs_of(const FrameRun& frame) const noexcept;
    bool stands_out(const Signs& signs) const noexcept;
    void follow(const FrameRun& frame);
    /// `alone`: not as a sample of others.
    void redo(const FrameRun& frame, bool alone);
    void keep_books(const FrameRun& frame, double omega);
    /// J, that damping took, and whatever else is known, in so many steps of h seconds from where a trial
    /// starts; nothing where it cannot be run.
    std::optional<double> known_loss(double h, std::int64_t steps);
    /// In so many steps; nothing where that is rounding, or the frame cannot be redone.
    Loss loss_of(const FrameRun& frame, std::int64_t steps, double omega);
    bool judge(std::int64_t steps);
    /// As many steps as a frame took or twice as many, or of its tolerance or one that halves them, from x and
    /// v on; false where values come to mean nothing, or it takes too many.
    enum class Steps : std::uint8_t { alike, halved };
    bool run_frame(std::int64_t steps, Steps which, std::span<Vec3> x, std::span<Vec3> v);
    StepBudget budget() const { return {2 * settings_->max_substeps, settings_->stop_asked}; }
    /// Puts the trial to the frame's start.
    void start_trial(const FrameRun& frame) noexcept;

    SpringSystem* system_;
    const SimulationSettings* settings_;
    Integrator* integrator_;
    const Watch* watch_;
    std::unique_ptr<Integrator> judge_;  ///< null: the method itself, at half the step
    double frame_step_;                  ///< s
    ErrorMeter meter_;
    LostVibrations lost_;
    std::vector<Vec3> first_x_;                 ///< m, where the run began
    std::vector<Vec3> trial_x_, trial_v_;       ///< of a frame that is redone
    std::vector<Vec3> halved_x_, halved_v_;     ///< at the end of the last one redone at half the step
    std::vector<double> halved_creep_;          ///< m
    bool followed_ = false;                     ///< whether the next frame goes on from there too
    bool followed_alone_ = false;               ///< and that one stood out
    Signs most_{};                              ///< of frames that were redone
    std::optional<std::uint64_t> first_frame_;  ///< that was run: others are not told of
    double seconds_ = 0;
};

}  // namespace orbweaver::mass_spring
