#include "method_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adviser.hpp"
#include "integrator.hpp"
#include "larger.hpp"
#include "quantity.hpp"
#include "substep_plan.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr int kTrialFrames = 6;
constexpr double kMargin = 4;  // motion can grow past what the trials saw
constexpr std::array<std::string_view, 6> kCandidates = {"rk4",   "tr_bdf2", "tsit5",
                                                         "srkn6", "verlet",  "implicit_euler"};

/// Where every load's trial was after each of its frames, and what a frame of it cost.
struct TrialRun {
    std::vector<std::vector<Vec3>> x;
    double cost = 0;  ///< s a frame
    int order = 0;    ///< of convergence
};

class Trials {
public:
    Trials(SpringSystem& system, const Surroundings& surroundings, std::span<const Vec3> x,
           std::span<const std::vector<Vec3>> loads, const ChoiceGoal& goal)
        : system_(system), surroundings_(surroundings), x_(x), loads_(loads), goal_(goal) {}

    /// Goes down the ladder of a method's steps until the goal is met, or is not to be met as cheaply as
    /// `best`.
    void climb_down(const MethodInfo& method, std::optional<MethodTrial>& best) {
        if (method.undamped && is_damped(system_.network())) return;
        constexpr int kMostRungs = 14;
        constexpr int kMostIdle = 2;  // rungs that win nothing: down to rounding
        std::int64_t substeps = longest_steps(method);
        if (substeps == 0) return;
        const double evaluations = static_cast<double>(substeps * method.evaluations);
        if (too_long(evaluations * system_.evaluation_seconds(), best)) return;
        std::optional<TrialRun> here = run(method, substeps);
        std::optional<MethodTrial> nearest;
        double least = HUGE_VAL;
        int idle = 0;
        for (int rung = 0; rung < kMostRungs && here && !too_long(2 * here->cost, best);
             ++rung, substeps *= 2) {
            std::optional<TrialRun> halved = run(method, 2 * substeps);
            if (!halved) break;
            const MethodTrial trial{&method, goal_.frame_step / static_cast<double>(substeps),
                                    error_of(*here, *halved), here->cost};
            here = std::move(halved);
            if (std::isfinite(trial.error) && better(trial, nearest)) nearest = trial;
            idle = trial.error < least ? 0 : idle + 1;
            least = std::min(least, trial.error);
            if (meets_tolerance(trial) || over_budget(here->cost) || idle == kMostIdle) break;
        }
        if (nearest) tried_.push_back(*nearest);
        if (nearest && better(*nearest, best)) best = nearest;
    }

    bool meets_goal(const MethodTrial& trial) const {
        return goal_.tolerance > 0 ? kMargin * trial.error <= goal_.tolerance : trial.cost <= goal_.budget;
    }
    const std::vector<MethodTrial>& tried() const { return tried_; }

private:
    bool meets_tolerance(const MethodTrial& trial) const { return goal_.tolerance > 0 && meets_goal(trial); }
    bool over_budget(double cost) const { return goal_.tolerance == 0 && cost > goal_.budget; }

    /// What meets the goal before what does not; then, what is better in the other respect.
    bool better(const MethodTrial& trial, const std::optional<MethodTrial>& other) const {
        if (!other) return true;
        const bool meets = meets_goal(trial), other_meets = meets_goal(*other);
        if (meets != other_meets) return meets;
        const bool by_cost = meets == (goal_.tolerance > 0);
        return by_cost ? trial.cost < other->cost : trial.error < other->error;
    }

    std::int64_t longest_steps(const MethodInfo& method) const {
        const double stable = kSafety * advise(system_, x_, method).stable_step;
        if (stable == 0) return 0;
        return std::max<std::int64_t>(1, std::llround(std::ceil(goal_.frame_step / stable)));
    }

    /// Whether trials at that cost of a frame take longer than a choice is worth, or cannot be better.
    bool too_long(double cost, const std::optional<MethodTrial>& best) const {
        if (cost * kTrialFrames * static_cast<double>(load_count()) > kMostSeconds) return true;
        return best && meets_tolerance(*best) && cost > 2 * best->cost;
    }

    static constexpr double kMostSeconds = 0.6;  ///< of work, of one trial

    std::size_t load_count() const { return std::max<std::size_t>(1, loads_.size()); }

    /// Nothing where it takes longer than a choice is worth: of implicit methods it shows only then.
    std::optional<TrialRun> run(const MethodInfo& method, std::int64_t substeps) {
        constexpr double kMostSpent = 2 * kMostSeconds;  // s of work
        TrialRun done;
        const double before = system_.work_seconds();
        const double h = goal_.frame_step / static_cast<double>(substeps);
        for (std::size_t load = 0; load < load_count(); ++load) {
            Surroundings surroundings = surroundings_;
            if (!loads_.empty()) surroundings.external = loads_[load];
            system_.set_surroundings(surroundings);
            std::vector<Vec3> x(x_.begin(), x_.end()), v(x_.size());
            system_.put_on_arms(x_);
            Integrator integrator(system_, method);
            done.order = integrator.order();
            for (int frame = 0; frame < kTrialFrames && system_.work_seconds() - before < kMostSpent; ++frame) {
                integrator.advance(x, v, h, substeps);
                done.x.push_back(x);
            }
        }
        system_.set_surroundings(surroundings_);
        if (done.x.size() < kTrialFrames * load_count()) return std::nullopt;
        done.cost = (system_.work_seconds() - before) / (kTrialFrames * static_cast<double>(load_count()));
        return done;
    }

    /// Of the run, m.
    double error_of(const TrialRun& whole, const TrialRun& halved) const {
        double largest = 0;
        for (std::size_t end = 0; end < whole.x.size(); ++end)
            for (std::size_t i = 0; i < x_.size(); ++i)
                largest = larger(largest, distance(whole.x[end][i], halved.x[end][i]));
        const double power = std::ldexp(1.0, whole.order);
        return largest * power / (power - 1) * goal_.frames / kTrialFrames;
    }

    SpringSystem& system_;
    Surroundings surroundings_;
    std::span<const Vec3> x_;
    std::span<const std::vector<Vec3>> loads_;
    ChoiceGoal goal_;
    std::vector<MethodTrial> tried_;  ///< the nearest to the goal of each method
};

std::string describe(const MethodTrial& trial) {
    return std::string(trial.method->name) + " at " + seconds_text(trial.step) + " (" +
           number_text(trial.error) + " m, " + seconds_text(trial.cost) + " a frame)";
}

std::string sentence_of(const MethodChoice& choice, const ChoiceGoal& goal,
                        const std::vector<MethodTrial>& tried) {
    if (tried.empty())
        return "a frame of any method takes too long to be tried; " + std::string(choice.chosen.method->name) +
               " in steps of " + seconds_text(choice.chosen.step) +
               ", which is stable at every step, is taken untried";
    std::string text =
        describe(choice.chosen) + " is " +
        (goal.tolerance > 0 ? "the cheapest within " + number_text(goal.tolerance) + " m"
                            : "the most accurate within " + seconds_text(goal.budget) + " a frame");
    if (!choice.meets_goal)
        text =
            "nothing tried is within " +
            (goal.tolerance > 0 ? number_text(goal.tolerance) + " m" : seconds_text(goal.budget) + " a frame") +
            "; " + describe(choice.chosen) + " comes nearest";
    std::string others;
    for (const MethodTrial& trial : tried)
        if (trial.method != choice.chosen.method) others += (others.empty() ? "" : ", ") + describe(trial);
    return others.empty() ? text : text + "; others: " + others;
}

}  // namespace

MethodChoice choose_method(SpringSystem& system, const Surroundings& surroundings, std::span<const Vec3> x,
                           std::span<const std::vector<Vec3>> loads, const ChoiceGoal& goal) {
    Trials trials(system, surroundings, x, loads, goal);
    std::optional<MethodTrial> best;
    for (const std::string_view name : kCandidates) trials.climb_down(*find_method(name), best);
    MethodChoice choice;
    // Too stiff for any trial: what holds at every step.
    choice.chosen = best.value_or(MethodTrial{find_method("tr_bdf2"), goal.frame_step, HUGE_VAL, HUGE_VAL});
    choice.meets_goal = trials.meets_goal(choice.chosen);
    choice.sentence = sentence_of(choice, goal, trials.tried());
    return choice;
}

}  // namespace orbweaver::mass_spring
