#include "run_error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "quantity.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Adds the wall time of its life to a sum of seconds.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) noexcept : seconds_(seconds) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

RunError::RunError(SpringSystem& system, const SimulationSettings& settings, Integrator& integrator,
                   const Watch& watch, double frame_step, std::span<const Vec3> x)
    : system_(&system),
      settings_(&settings),
      integrator_(&integrator),
      watch_(&watch),
      frame_step_(frame_step),
      meter_(settings.method->judge),
      first_x_(x.begin(), x.end()),
      trial_x_(x.size()),
      trial_v_(x.size()) {
    if (!settings.method->judge.empty())
        judge_ = std::make_unique<Integrator>(system, *find_method(settings.method->judge));
}

void RunError::add(const FrameRun& frame, double omega) {
    const Stopwatch watch(seconds_);
    meter_.count_frame();
    if (!first_frame_) first_frame_ = frame.index;
    if (followed_) follow(frame);
    const Signs signs = judge_ == nullptr ? signs_of(frame) : Signs{};
    const bool wanted = meter_.wants(frame.index);
    if (wanted || stands_out(signs)) {
        redo(frame, !wanted);
        for (std::size_t i = 0; i < signs.size(); ++i) most_[i] = std::max(most_[i], signs[i]);
    }
    keep_books(frame, omega);
}

RunError::Signs RunError::signs_of(const FrameRun& frame) const noexcept {
    // How far springs turn within the frame, as 1 - cos: what passes by another closely turns it about.
    double turn = 0;
    for (const Spring& s : system_->network().springs) {
        const Vec3 before = frame.start_x[s.a] - frame.start_x[s.b], after = frame.x[s.a] - frame.x[s.b];
        const double lengths = std::sqrt(dot(before, before) * dot(after, after));
        if (lengths > 0) turn = std::max(turn, 1 - dot(before, after) / lengths);
    }
    return {frame.told_error, turn, std::max(0.0, frame.balance.gain - frame.balance.rounding)};
}

bool RunError::stands_out(const Signs& signs) const noexcept {
    constexpr double kMore = 2;          // times as much as any that was redone: few do, however long a run
    constexpr Signs kLeast{0, 0.03, 0};  // a quarter of a radian is no event
    for (std::size_t i = 0; i < signs.size(); ++i)
        if (signs[i] > kMore * most_[i] && signs[i] > kLeast[i]) return true;
    return false;
}

void RunError::redo(const FrameRun& frame, bool alone) {
    start_trial(frame);
    const bool redone =
        judge_ != nullptr ? judge(frame.steps) : run_frame(frame.steps, Steps::halved, trial_x_, trial_v_);
    if (settings_->stop_asked && settings_->stop_asked())
        return;  // the run ends: the samples so far stand for this frame too
    if (!redone) {
        meter_.add_unknown();
    } else if (judge_ != nullptr) {
        meter_.add_judged(frame.x, trial_x_, frame.v, trial_v_, frame_step_);
    } else {
        alone ? meter_.add_alone(frame.x, trial_x_, integrator_->order())
              : meter_.add(frame.x, trial_x_, integrator_->order());
        halved_x_ = trial_x_;
        halved_v_ = trial_v_;
        halved_creep_.resize(frame.start_creep.size());
        system_->get_creep(halved_creep_);
        followed_ = true;
        followed_alone_ = alone;
    }
}

void RunError::follow(const FrameRun& frame) {
    followed_ = false;
    system_->begin_frame(halved_creep_);
    if (run_frame(frame.steps, Steps::alike, halved_x_, halved_v_))
        followed_alone_ ? meter_.follow_alone(frame.x, halved_x_, integrator_->order())
                        : meter_.follow(frame.x, halved_x_, integrator_->order());
}

bool RunError::judge(std::int64_t steps) {
    constexpr std::int64_t kMostJudged = 128;  // of an implicit method: what these err may count too
    const std::int64_t count = std::min(steps, kMostJudged);
    StepBudget steps_left = budget();
    return advance_watched(*judge_, *watch_, trial_x_, trial_v_, frame_step_ / static_cast<double>(count),
                           count, steps_left);
}

bool RunError::run_frame(std::int64_t steps, Steps which, std::span<Vec3> x, std::span<Vec3> v) {
    StepBudget steps_left = budget();
    const std::int64_t count = which == Steps::halved ? 2 * steps : steps;
    const double h = frame_step_ / static_cast<double>(count);
    if (settings_->tolerance == 0) return advance_watched(*integrator_, *watch_, x, v, h, count, steps_left);
    // A step's error shrinks with its length to the power of the embedded order plus one.
    const double shrunk = which == Steps::halved ? std::ldexp(1.0, settings_->method->embedded_order + 1) : 1;
    return integrator_->advance_within(x, v, frame_step_, settings_->tolerance / shrunk, h, steps_left)
               .finished &&
           watch_->first_bad(x, v) == x.size();
}

void RunError::keep_books(const FrameRun& frame, double omega) {
    const double h = frame_step_ / static_cast<double>(frame.steps);
    const bool followed = h * omega < LostVibrations::kFollowed;
    const bool in_the_books = frame.start_creep.empty();  // dashpots take energy that they do not know
    if (judge_ != nullptr || followed || !in_the_books) return;
    lost_.count_frame(frame.balance.turnover, largest_distance(first_x_, frame.x));
    if (!LostVibrations::samples(frame.index)) return;
    const Loss whole = loss_of(frame, frame.steps, omega);
    lost_.add(whole, whole.energy > 0 ? loss_of(frame, 2 * frame.steps, omega) : Loss{});
}

std::optional<double> RunError::known_loss(double h, std::int64_t steps) {
    StepBudget steps_left = budget();
    if (const StepHooks* hooks = system_->hooks()) {
        if (!integrator_->advance(trial_x_, trial_v_, h, steps, steps_left)) return {};
        return hooks->other_loss();
    }
    double before = dissipated_power(*system_, trial_x_, trial_v_), lost = 0;
    for (std::int64_t i = 0; i < steps; ++i) {
        if (!integrator_->advance(trial_x_, trial_v_, h, 1, steps_left)) return {};
        const double after = dissipated_power(*system_, trial_x_, trial_v_);
        lost += h / 2 * (before + after);
        before = after;
    }
    return lost;
}

Loss RunError::loss_of(const FrameRun& frame, std::int64_t steps, double omega) {
    const double h = frame_step_ / static_cast<double>(steps);
    start_trial(frame);
    const Phase start = phase_of(*system_, trial_x_, trial_v_);
    const std::optional<double> explained = known_loss(h, steps);
    if (!explained) return {};
    const EnergyBalance balance =
        balance_energy(*system_, frame.start_energy, frame.start_x, trial_x_, trial_v_);
    const double unexplained = -balance.gain - *explained;
    if (!(unexplained > balance.rounding)) return {};
    const double slowest = std::min(omega, LostVibrations::kFollowed / h);
    return loss_between(system_->network(), start, phase_of(*system_, trial_x_, trial_v_), unexplained, slowest,
                        omega);
}

void RunError::start_trial(const FrameRun& frame) noexcept {
    std::copy(frame.start_x.begin(), frame.start_x.end(), trial_x_.begin());
    std::copy(frame.start_v.begin(), frame.start_v.end(), trial_v_.begin());
    system_->begin_frame(frame.start_creep);
}

double RunError::estimate() const noexcept { return meter_.estimate() + lost_.amplitude() + lost_.felt(); }

std::string RunError::how() const {
    std::string text = meter_.how();
    if (first_frame_.value_or(0) > 0)
        text += "; of what came before frame " + std::to_string(*first_frame_) + " nothing is told";
    if (!(lost_.energy() > 0)) return text;
    return text + "; vibrations too fast for the steps, which the method damped out with " +
           number_text(lost_.energy()) + " J: " + number_text(lost_.amplitude()) +
           " m of themselves, and slower motion that felt them may be off by " + number_text(lost_.felt()) +
           " m";
}

std::size_t RunError::memory_bytes() const noexcept {
    const std::size_t judge = judge_ != nullptr ? judge_->memory_bytes() : 0;
    return judge +
           (first_x_.capacity() + trial_x_.capacity() + trial_v_.capacity() + halved_x_.capacity() +
            halved_v_.capacity()) *
               sizeof(Vec3) +
           halved_creep_.capacity() * sizeof(double);
}

}  // namespace orbweaver::mass_spring
