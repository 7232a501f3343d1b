#include "simulation.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "quantity.hpp"
#include "step_bound.hpp"
#include "substep_plan.hpp"

namespace orbweaver::mass_spring {
namespace {

/// A whole number that a double holds.
double mark_of(const MethodInfo& method) noexcept { return static_cast<double>(method_key(method) >> 12); }

}  // namespace

Simulation::Simulation(SpringSystem& system, SimulationSettings settings, double frame_step, std::span<Vec3> x,
                       std::span<Vec3> v, std::span<double> memory, std::span<double> creep)
    : system_(&system),
      settings_(std::move(settings)),
      frame_step_(frame_step),
      x_(x),
      v_(v),
      memory_(memory.size() == kSimulationMemory ? memory : std::span<double>(own_memory_)),
      creep_(creep),
      integrator_(system, *settings_.method),
      watch_(x),
      error_(system, settings_, integrator_, watch_, frame_step, x),
      start_x_(x.begin(), x.end()),
      start_v_(v.begin(), v.end()) {
    for (std::size_t i = 0; i < v_.size(); ++i) {
        if (system.network().fixed[i] != 0) v_[i] = {};
    }
    check_damping();
    put_on_arms();
    look();
    advice_holds_ = true;
}

void Simulation::check_damping() const {
    if (!settings_.method->undamped || !is_damped(system_->network())) return;
    throw Fault(FaultKind::invalid, "springs are damped, which " + std::string(settings_.method->name) +
                                        " does not take: set their damping to 0 and let drag damp, or choose "
                                        "another method, as tsit5");
}

void Simulation::put_on_arms() {
    system_->put_on_arms(x_);
    if (system_->hooks() != nullptr && settings_.tolerance > 0)
        throw Fault(FaultKind::invalid, "a tolerance of " + number_text(settings_.tolerance) +
                                            " m a step is asked where contact or muscles act between steps, "
                                            "whose error no method tells; say the step instead");
    if (system_->creep_count() > 0 && settings_.tolerance > 0)
        throw Fault(FaultKind::invalid,
                    "a tolerance of " + number_text(settings_.tolerance) +
                        " m a step is asked of threads that relax, whose error no method tells; say the step "
                        "instead, or leave the hysteresis out");
    if (creep_.size() != system_->creep_count()) {
        own_creep_.resize(system_->creep_count());
        creep_ = own_creep_;
    }
    system_->get_creep(creep_);
    end_creep_.resize(creep_.size());
}

void Simulation::network_changed() {
    system_->network_changed();
    check_damping();
    const std::vector<double> before(creep_.begin(), creep_.end());
    put_on_arms();
    if (before.size() == creep_.size()) std::copy(before.begin(), before.end(), creep_.begin());
    error_.network_changed();
    advice_holds_ = false;
    look();
}

void Simulation::look() {
    if (settings_.tolerance > 0) {
        choose_first_step();
    } else {
        bound_step_ = kSafety * bound_step(*system_, *settings_.method);
        choose_substep();
    }
}

void Simulation::choose_first_step() {
    advice_ = advise(*system_, x_, *settings_.method);
    const double stable = advice_.stable_step > 0 ? advice_.stable_step : frame_step_;
    set_substep(std::min(frame_step_, settings_.step > 0 ? settings_.step : kSafety * stable));
}

void Simulation::choose_substep() {
    if (!advice_holds_) advice_ = advise(*system_, x_, *settings_.method);
    const SubstepPlan plan = plan_substeps(settings_, advice_, frame_step_);
    set_substep(frame_step_ / static_cast<double>(plan.count));
    if (plan.warning.empty() || warned_) return;
    warned_ = true;
    if (settings_.warn) settings_.warn(plan.warning);
}

void Simulation::set_substep(double seconds) noexcept {
    memory_[0] = seconds;
    memory_[1] = mark_of(*settings_.method);
}
double Simulation::substep() const noexcept { return memory_[0]; }
const Advice& Simulation::advice() const noexcept { return advice_; }
std::uint64_t Simulation::steps() const noexcept { return steps_; }
double Simulation::energy_gain() const noexcept { return energy_gain_; }

std::int64_t Simulation::substeps_per_frame() const noexcept {
    return static_cast<std::int64_t>(std::llround(frame_step_ / substep()));
}

std::size_t Simulation::memory_bytes() const noexcept {
    return system_->memory_bytes() + integrator_.memory_bytes() + error_.memory_bytes() +
           2 * x_.size() * sizeof(Vec3);
}

FrameRun Simulation::frame_run(std::uint64_t index, std::int64_t steps, const EnergyBalance& balance) const {
    return {index, steps, start_x_, x_, start_v_, v_, creep_, start_energy_, balance, 0};
}

void Simulation::advance(std::uint64_t frame, double time) {
    advice_holds_ = advice_holds_ && std::equal(x_.begin(), x_.end(), start_x_.begin());
    std::copy(x_.begin(), x_.end(), start_x_.begin());
    std::copy(v_.begin(), v_.end(), start_v_.begin());
    system_->begin_frame(creep_);
    start_energy_ = system_->energy(x_, v_);
    if (const std::size_t bad = watch_.first_bad(x_, v_); bad < x_.size()) {
        throw Fault(FaultKind::diverged,
                    "particle " + std::to_string(bad) +
                        " is not at a finite place with a finite velocity at t = " + seconds_text(time) +
                        ", where frame " + std::to_string(frame) + " starts");
    }
    settings_.tolerance > 0 ? advance_within_tolerance(frame, time) : advance_in_equal_steps(frame, time);
}

void Simulation::advance_within_tolerance(std::uint64_t frame, double time) {
    const ControlledRun run = integrator_.advance_within(x_, v_, frame_step_, settings_.tolerance, substep(),
                                                         {settings_.max_substeps, settings_.stop_asked});
    if (run.stopped) stop(frame, time);
    steps_ += static_cast<std::uint64_t>(run.steps);
    if (!run.finished || watch_.first_bad(x_, v_) < x_.size()) {
        restore_start();
        throw Fault(FaultKind::diverged,
                    "frame " + std::to_string(frame) + " at t = " + seconds_text(time) +
                        " could not be finished with errors of at most " + number_text(settings_.tolerance) +
                        " m a step: after " + std::to_string(run.steps) +
                        " steps, parts of divided ones counted, " + std::string(settings_.method->name) +
                        " was down to steps of " + seconds_text(run.next) + "; the state at t = " +
                        seconds_text(time) + " is kept; ask for a larger tolerance, or an implicit method");
    }
    set_substep(run.next);
    const EnergyBalance balance = balance_energy(*system_, start_energy_, start_x_, x_, v_);
    energy_gain_ += std::max(0.0, balance.gain);
    FrameRun taken = frame_run(frame, run.steps, balance);
    taken.told_error = run.error;
    error_.add(taken, advice_.angular_frequency);
}

void Simulation::advance_in_equal_steps(std::uint64_t frame, double time) {
    const bool of_another_method = memory_[1] != mark_of(*settings_.method);
    if (frame % kFramesPerAdvice == 0 || of_another_method) choose_substep();
    advice_holds_ = false;
    EnergyBalance balance;
    bool finished = run_frame(frame, time, balance);
    if (may_be_unstable() && !(finished && balance.holds()))
        finished = answer_instability(frame, time, finished, balance);
    if (!finished) fail(frame, time);
    energy_gain_ += std::max(0.0, balance.gain);
    steps_ += static_cast<std::uint64_t>(frame_steps_);
    if (system_->hooks() != nullptr) system_->hooks()->keep();
    system_->get_creep(end_creep_);
    error_.add(frame_run(frame, substeps_per_frame(), balance), advice_.angular_frequency);
    std::copy(end_creep_.begin(), end_creep_.end(), creep_.begin());
    system_->set_creep(creep_);
}

bool Simulation::run_frame(std::uint64_t frame, double time, EnergyBalance& balance) {
    const std::int64_t count = substeps_per_frame();
    StepBudget budget(settings_.max_substeps, settings_.stop_asked);
    const bool finished =
        advance_watched(integrator_, watch_, x_, v_, frame_step_ / static_cast<double>(count), count, budget);
    if (budget.stopped()) stop(frame, time);
    if (budget.refused()) refuse_parts(frame, time);
    frame_steps_ = budget.taken();
    if (!finished) return false;
    balance = balance_energy(*system_, start_energy_, start_x_, x_, v_);
    return true;
}

bool Simulation::may_be_unstable() const noexcept { return !is_bounded() || substep() > bound_step_; }

bool Simulation::leaves_springs_unmet() const noexcept {
    return !settings_.method->judge.empty() && std::isinf(advice_.stable_step);
}

bool Simulation::is_bounded() const noexcept { return bound_step_ > 0 && !std::isinf(bound_step_); }

bool Simulation::redo_shorter(std::uint64_t frame, double time, bool finished, EnergyBalance& balance) {
    constexpr int kMostHalvings = 10;
    for (int i = 0; i < kMostHalvings && !(finished && balance.holds()); ++i) {
        if (!is_bounded() && 2 * substeps_per_frame() > settings_.max_substeps) break;
        restore_start();
        // Linear theory knows no bound for implicit methods, nor for those that damping alone makes stable.
        const double shorter = is_bounded() ? bound_step_ : substep() / 2;
        const std::int64_t count = count_bounded(settings_, shorter, frame_step_);
        set_substep(frame_step_ / static_cast<double>(count));
        finished = run_frame(frame, time, balance);
        if (is_bounded()) break;
    }
    return finished;
}

bool Simulation::answer_instability(std::uint64_t frame, double time, bool finished, EnergyBalance& balance) {
    std::string sentence =
        "frame " + std::to_string(frame) + " at t = " + seconds_text(time) +
        (finished ? " gained " + number_text(balance.gain) + " J from nowhere" : " could not be finished") +
        " at steps of " + seconds_text(substep());
    if (settings_.on_unstable == OnUnstable::substep) {
        finished = redo_shorter(frame, time, finished, balance);
        if (!finished) return false;
        if (!is_bounded() && !balance.holds()) {
            restore_start();
            throw Fault(FaultKind::diverged,
                        sentence + ", and " + number_text(balance.gain) + " J at " + seconds_text(substep()) +
                            "; the state at t = " + seconds_text(time) +
                            " is kept; choose another method, or " + "ask for a shorter step");
        }
        sentence +=
            leaves_springs_unmet()
                ? ": " + std::string(settings_.method->name) +
                      " corrects each spring once a step, which left too much undone; it is redone, and "
                      "goes on, at " +
                      seconds_text(substep()) +
                      "; on_unstable = \"as_asked\" keeps the steps, and an implicit method needs fewer"
                : ": it moved out of the arrangement that they were advised for; it is redone at " +
                      seconds_text(substep()) + (is_bounded() ? ", stable in every arrangement" : "");
        warn_of_gain(sentence);
        return true;
    }
    if (!finished) return false;
    if (settings_.on_unstable == OnUnstable::stop) {
        restore_start();
        throw Fault(FaultKind::diverged, sentence + "; ask for shorter ones, or for on_unstable = \"substep\"");
    }
    warn_of_gain(sentence + ", which were asked for; it goes on");
    return true;
}

void Simulation::warn_of_gain(const std::string& sentence) {
    if (settings_.warn && !warned_of_gain_) settings_.warn(sentence);
    warned_of_gain_ = true;
}

void Simulation::restore_start() noexcept {
    std::copy(start_x_.begin(), start_x_.end(), x_.begin());
    std::copy(start_v_.begin(), start_v_.end(), v_.begin());
    system_->begin_frame(creep_);
}

void Simulation::stop(std::uint64_t frame, double time) {
    restore_start();
    throw Fault(FaultKind::stopped, "frame " + std::to_string(frame) + " at t = " + seconds_text(time) +
                                        " was given up, as was asked; the state at t = " + seconds_text(time) +
                                        " is kept");
}

void Simulation::refuse_parts(std::uint64_t frame, double time) {
    const double h = substep();
    restore_start();
    throw Fault(FaultKind::diverged,
                "frame " + std::to_string(frame) + " at t = " + seconds_text(time) + " was given up after " +
                    std::to_string(settings_.max_substeps) +
                    " steps and parts of steps: " + std::string(settings_.method->name) + " divides those of " +
                    seconds_text(h) + " in which it does not find the motion; expected at most " +
                    std::to_string(settings_.max_substeps) + " in all; the state at t = " + seconds_text(time) +
                    " is kept; ask for a shorter step, or lower stiffness and loads");
}

void Simulation::fail(std::uint64_t frame, double time) {
    const std::int64_t count = substeps_per_frame();
    const double h = substep();
    const std::size_t bad_at_end = watch_.first_bad(x_, v_);
    restore_start();
    std::vector<Vec3> before_x(x_.size()), before_v(v_.size());
    std::int64_t done = 0;
    std::size_t bad = x_.size();
    StepBudget budget(settings_.max_substeps, settings_.stop_asked);
    while (bad == x_.size() && done < count && !budget.refused()) {
        std::copy(x_.begin(), x_.end(), before_x.begin());
        std::copy(v_.begin(), v_.end(), before_v.begin());
        integrator_.advance(x_, v_, frame_step_ / static_cast<double>(count), 1, budget);
        bad = watch_.first_bad(x_, v_);
        ++done;
    }
    // An implicit method that makes its matrix anew for every step may come through.
    const bool again = bad < x_.size();
    if (!again) bad = bad_at_end;
    std::string what;
    if (again && is_finite(x_[bad]) && is_finite(v_[bad])) {
        what = "the position of particle " + std::to_string(bad) +
               " left for more than a million times the extent";
    } else {
        const Culprit culprit = find_culprit(*system_, before_x, before_v, bad);
        what = "the ";
        what += culprit.term;
        what += " on particle " + std::to_string(culprit.particle) + " stopped it being finite";
    }
    restore_start();
    throw Fault(FaultKind::diverged, what + " at t = " + seconds_text(time + static_cast<double>(done) * h) +
                                         " (frame " + std::to_string(frame) + ", step " + std::to_string(done) +
                                         " of " + std::to_string(count) + ", each " + seconds_text(h) +
                                         "); the state at t = " + seconds_text(time) + " is kept; " +
                                         advice_.sentence);
}

}  // namespace orbweaver::mass_spring
