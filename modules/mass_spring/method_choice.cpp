#include "method_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "adviser.hpp"
#include "error_growth.hpp"
#include "larger.hpp"
#include "orbweaver/fault.hpp"
#include "quantity.hpp"
#include "substep_plan.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kMargin = 4;         // motion can grow past what the trials saw
constexpr double kMostWork = 2;       // s, of all trials
constexpr double kFirstTrial = 0.12;  // s of work, of the cheapest method at its longest step and at half of it
constexpr double kTwins = 0.3;        // s of work
constexpr std::size_t kFewestFrames = 6, kMostFrames = 512;
constexpr double kMostPositions = 2e6;  // kept of a run: 50 MB
constexpr std::array<std::string_view, 7> kCandidates = {"symplectic_euler", "verlet", "rk4", "tsit5", "srkn6",
                                                         "implicit_euler",   "tr_bdf2"};

/// A method at a step that may be tried.
struct Way {
    Pace pace;
    double cost = 0;          ///< s a frame, expected
    int order = 1;            ///< of convergence
    bool limited = true;      ///< by stability
    double least = HUGE_VAL;  ///< m, that its longer steps erred by
    int idle = 0;             ///< halvings that won nothing: down to rounding
};

/// By how much positions differ, m.
double difference(const Performance& a, const Performance& b) noexcept {
    double largest = 0;
    for (std::size_t i = 0; i < a.x.size(); ++i) largest = larger(largest, distance(a.x[i], b.x[i]));
    return largest;
}

/// The farthest that anything gets from where it is at the start, m.
double reach(const Performance& run, std::span<const Vec3> start) noexcept {
    double largest = 0;
    for (std::size_t i = 0; i < run.x.size(); ++i)
        largest = larger(largest, distance(run.x[i], start[i % start.size()]));
    return largest;
}

/// What a frame leaves of the motion that drag damps least.
double left_by_drag(const Network& network, double drag, double frame_step) {
    double heaviest = 0;
    for (std::size_t i = 0; i < network.size(); ++i)
        if (network.fixed[i] == 0) heaviest = std::max(heaviest, network.mass[i]);
    return heaviest > 0 ? 1 / (1 + drag / heaviest * frame_step / 2) : 1;
}

class Trials {
public:
    Trials(SpringSystem& system, const RunAhead& run, const ChoiceGoal& goal)
        : system_(system), run_(run), goal_(goal), start_(system.work_seconds()), rehearsal_(system, run) {}

    MethodChoice choose() {
        list_ways();
        if (ways_.empty()) return untried();
        if (!rehearse()) return untried();
        while (!ways_.empty()) {
            Way way = take(exact_ ? cheapest() : first());
            if (best_ && (way.cost >= most_cost() || !may_take(way.cost))) continue;
            const std::optional<MethodTrial> trial = try_out(way);
            if (!trial) continue;
            consider(*trial);
            if (!(meets_tolerance(trial->error) || trial->cost > budget())) halve(way, *trial);
        }
        if (!best_) return untried();
        MethodChoice choice{
            of_the_run(*best_), meets_goal(*best_) && !(goal_.tolerance > 0 && is_chaotic()), {}};
        choice.sentence = sentence_of(choice);
        return choice;
    }

private:
    void list_ways() {
        for (const std::string_view name : kCandidates) {
            const MethodInfo& method = *find_method(name);
            if (method.undamped && is_damped(system_.network())) continue;
            const double stable = kSafety * advise(system_, run_.x, method).stable_step;
            if (stable == 0) continue;
            const double substeps = std::max(1.0, std::ceil(run_.frame_step / stable));
            if (substeps > static_cast<double>(goal_.max_substeps)) {
                cramped_ = true;
                continue;
            }
            Way way{{&method, static_cast<std::int64_t>(substeps)}};
            way.cost = substeps * method.evaluations * system_.evaluation_seconds();
            // What an implicit method takes shows in a frame only: too many parts of steps, maybe.
            way.limited = std::isfinite(stable);
            if (!way.limited) {
                const auto frame = rehearsal_.cost_of_a_frame(way.pace, limit());
                cramped_ = cramped_ || !frame;
                if (!frame) continue;
                way.cost = *frame;
            }
            ways_.push_back(way);
        }
    }

    /// Decides what is rehearsed, and how errors grow beyond it. False where there is no time for it.
    bool rehearse() {
        const Way& first = *this->first();
        const std::size_t frames = frames_within(kFirstTrial / 3, first.cost);
        if (3 * static_cast<double>(frames) * first.cost > kMostWork) return false;
        constexpr double kNearlyAll = 1.5;
        if (kNearlyAll * static_cast<double>(frames) >= run_.frames) {
            rehearsal_.take_first(static_cast<std::size_t>(std::ceil(run_.frames)));
            return true;
        }
        const std::size_t horizon = std::max(frames, frames_within(kTwins / 2, first.cost));
        const double left = left_by_drag(system_.network(), run_.surroundings.drag, run_.frame_step);
        parted_ = rehearsal_.take_strongest(frames, horizon, first.pace,
                                            {std::min(kTwins, work_left()), goal_.max_substeps});
        growth_.emplace(parted_, left);
        return true;
    }

    std::size_t frames_within(double seconds, double cost) const {
        const double most = std::min({static_cast<double>(kMostFrames), std::ceil(run_.frames),
                                      kMostPositions / static_cast<double>(run_.x.size())});
        const double affordable = std::min(most, cost > 0 ? seconds / cost : most);
        return std::max(std::min(kFewestFrames, static_cast<std::size_t>(std::ceil(run_.frames))),
                        static_cast<std::size_t>(affordable));
    }

    using Place = std::vector<Way>::iterator;
    Place cheapest() { return std::min_element(ways_.begin(), ways_.end(), by_cost); }
    static bool by_cost(const Way& a, const Way& b) { return a.cost < b.cost; }

    /// What is compared with first: the cheapest whose stability asks for its step, if there is work for that.
    /// Where steps follow no vibration, two of them lose it alike, and tell nothing of their error.
    Place first() {
        const double most = kMostWork / 4 / (3 * static_cast<double>(kFewestFrames));
        Place found = ways_.end();
        for (Place way = ways_.begin(); way != ways_.end(); ++way)
            if (way->limited && way->cost <= most && (found == ways_.end() || way->cost < found->cost))
                found = way;
        return found != ways_.end() ? found : cheapest();
    }

    Way take(Place place) {
        const Way way = *place;
        ways_.erase(place);
        return way;
    }

    /// A trial of what costs more than the best that meets the goal need not be ended.
    WorkLimit limit_of_trial() const {
        WorkLimit most = limit();
        if (best_ && meets_tolerance(best_->error))
            most.seconds = std::min(most.seconds, best_->cost * static_cast<double>(rehearsal_.frames()));
        return most;
    }
    double work_left() const { return kMostWork - (system_.work_seconds() - start_); }
    WorkLimit limit() const { return {work_left(), goal_.max_substeps}; }
    bool may_take(double cost) const { return cost * static_cast<double>(rehearsal_.frames()) <= work_left(); }
    double budget() const { return goal_.tolerance > 0 ? HUGE_VAL : goal_.budget; }
    /// What costs as much is not chosen any more, and a tenth less is not worth a trial.
    double most_cost() const {
        constexpr double kWorthATrial = 0.9;
        return meets_tolerance(best_->error) ? kWorthATrial * best_->cost : std::nextafter(budget(), HUGE_VAL);
    }

    /// Its error is of the frames rehearsed. Nothing where it takes too long, or its motion means nothing.
    std::optional<MethodTrial> try_out(Way& way) {
        std::optional<Performance> run;
        if (way.pace.method == exact_pace_.method && way.pace.substeps == exact_pace_.substeps)
            run = exact_;
        else
            run = rehearsal_.perform(way.pace, limit_of_trial());
        if (!run) return std::nullopt;
        way.order = run->order;
        const double step = run_.frame_step / static_cast<double>(way.pace.substeps);
        MethodTrial trial{way.pace.method, step, HUGE_VAL, run->cost};
        if (exact_) trial.error = difference(*run, *exact_);
        if (std::isnan(trial.error)) trial.error = HUGE_VAL;
        if (!exact_ || trial.error <= 2 * exact_error_) judge_by_half(way, *run, trial);
        return trial;
    }

    /// By Richardson; the run at half the step is from then on what others are compared with.
    void judge_by_half(const Way& way, const Performance& run, MethodTrial& trial) {
        if (exact_ && 2 * run.cost * static_cast<double>(rehearsal_.frames()) > work_left())
            return agree(trial);
        const Pace half{way.pace.method, 2 * way.pace.substeps};
        auto halved = rehearsal_.perform(half, {work_left(), std::numeric_limits<std::int64_t>::max()});
        if (!halved && exact_) return agree(trial);
        trial.error = HUGE_VAL;
        if (!halved) return;
        const double apart = difference(run, *halved);
        if (!std::isfinite(apart)) return;
        const double power = std::ldexp(1.0, run.order);
        exact_ = std::move(halved);
        exact_error_ = apart;
        exact_pace_ = half;
        reach_ = std::max(reach_, reach(*exact_, run_.x));
        trial.error = apart * power / (power - 1);
    }

    /// It is no farther from the most exact run than that may be off itself.
    void agree(MethodTrial& trial) const {
        trial.error += exact_error_;
        trial.at_most = true;
    }

    /// As often as its order asks, or the budget allows; once where nothing is to be told by that.
    void halve(Way way, const MethodTrial& trial) {
        constexpr int kMostIdle = 2, kMostHalvings = 12;
        constexpr double kRounding = 1e-13;
        if (trial.error <= kRounding * reach_) return;
        way.idle = trial.error < way.least ? 0 : way.idle + 1;
        way.least = std::min(way.least, trial.error);
        way.cost = trial.cost;
        double error = kMargin * chosen_by(trial.error);
        for (int i = 0; i < kMostHalvings; ++i) {
            way.pace.substeps *= 2;
            way.cost *= 2;
            error = std::ldexp(error, -way.order);
            const bool enough = goal_.tolerance > 0 ? error <= goal_.tolerance : 2 * way.cost > goal_.budget;
            if (enough || std::isinf(error) || !may_take(2 * way.cost)) break;
            if (2 * way.pace.substeps > goal_.max_substeps) break;
        }
        if (way.idle < kMostIdle && way.pace.substeps <= goal_.max_substeps) ways_.push_back(way);
    }

    /// Of the run, m, by which it is chosen: where chance rules, what the method itself adds to it.
    double chosen_by(double error) const {
        return growth_ ? error * (is_chaotic() ? damped() : grown()) : error;
    }
    double grown() const {
        return rehearsal_.strength_ahead() *
               growth_->from(static_cast<double>(rehearsal_.longest_stretch()), run_.frames);
    }
    double damped() const {
        return rehearsal_.strength_ahead() *
               growth_->damped_from(static_cast<double>(rehearsal_.longest_stretch()), run_.frames);
    }
    bool is_chaotic() const { return growth_ && growth_->is_chaotic(run_.frames); }

    /// With the error of the whole run, which no two motions differ by more than they reach.
    MethodTrial of_the_run(MethodTrial trial) const {
        if (growth_) trial.error = std::min(trial.error * grown(), std::max(trial.error, reach_));
        return trial;
    }

    bool meets_tolerance(double error) const {
        return goal_.tolerance > 0 && kMargin * chosen_by(error) <= goal_.tolerance;
    }
    bool meets_goal(const MethodTrial& trial) const {
        return goal_.tolerance > 0 ? meets_tolerance(trial.error) : trial.cost <= goal_.budget;
    }

    void consider(const MethodTrial& trial) {
        if (!std::isfinite(trial.error)) return;
        const auto same = std::find_if(tried_.begin(), tried_.end(),
                                       [&](const MethodTrial& t) { return t.method == trial.method; });
        if (same == tried_.end())
            tried_.push_back(trial);
        else if (better(trial, *same))
            *same = trial;
        if (!best_ || better(trial, *best_)) best_ = trial;
    }

    /// What meets the goal before what does not; then, what is better in the other respect, and by a half at
    /// least where it costs more.
    bool better(const MethodTrial& trial, const MethodTrial& other) const {
        const bool meets = meets_goal(trial), other_meets = meets_goal(other);
        if (meets != other_meets) return meets;
        if (goal_.tolerance > 0 ? meets : !meets && goal_.tolerance == 0) return trial.cost < other.cost;
        return trial.error < (trial.cost > other.cost ? 0.5 : 1) * other.error;
    }

    std::string describe(const MethodTrial& tried) const {
        const MethodTrial trial = of_the_run(tried);
        return std::string(trial.method->name) + " at " + seconds_text(trial.step) + " (" +
               (trial.at_most ? "at most " : "") + number_text(trial.error) + " m, " +
               seconds_text(trial.cost) + " a frame)";
    }

    std::string goal_text() const {
        return goal_.tolerance > 0 ? number_text(goal_.tolerance) + " m"
                                   : seconds_text(goal_.budget) + " a frame";
    }

    std::string sentence_of(const MethodChoice& choice) const {
        std::string text = describe(*best_);
        if (meets_goal(*best_))
            text += std::string(" is the ") + (goal_.tolerance > 0 ? "cheapest" : "most accurate") +
                    " within " + goal_text();
        else
            text = "nothing tried is within " + goal_text() + "; " + text + " comes nearest";
        if (!choice.meets_goal && is_chaotic() && meets_goal(*best_))
            text += " over the " + std::to_string(rehearsal_.frames()) +
                    " frames that were tried; over the run no method is, since the motion is chaotic";
        if (goal_.tolerance > 0 && is_chaotic() && !meets_goal(*best_)) text += "; the motion is chaotic";
        if (!choice.meets_goal && cramped_)
            text +=
                "; max_substeps = " + std::to_string(goal_.max_substeps) + " leaves out what takes more steps";
        std::string others;
        for (const MethodTrial& trial : tried_)
            if (trial.method != best_->method) others += (others.empty() ? "" : ", ") + describe(trial);
        return others.empty() ? text : text + "; others: " + others;
    }

    /// Too stiff or too large for any trial: what holds at every step, if that is all that is known.
    MethodChoice untried() const {
        if (cramped_)
            throw Fault(FaultKind::diverged, "nothing that was tried holds with a frame of " +
                                                 seconds_text(run_.frame_step) + " in at most " +
                                                 std::to_string(goal_.max_substeps) +
                                                 " steps; allow more by max_substeps");
        const MethodInfo* method = find_method("tr_bdf2");
        return {{method, run_.frame_step, HUGE_VAL, HUGE_VAL},
                false,
                "a frame of any method takes too long to be tried; " + std::string(method->name) +
                    " in steps of " + seconds_text(run_.frame_step) +
                    ", which is stable at every step, is taken untried"};
    }

    SpringSystem& system_;
    RunAhead run_;
    ChoiceGoal goal_;
    double start_;  ///< s of work
    std::vector<Way> ways_;
    Rehearsal rehearsal_;
    std::vector<double> parted_;
    std::optional<ErrorGrowth> growth_;  ///< nothing where the whole run is rehearsed
    std::optional<Performance> exact_;   ///< the most exact run so far, of
    Pace exact_pace_;
    double exact_error_ = 0;          ///< m
    double reach_ = 0;                ///< m
    bool cramped_ = false;            ///< a method is left out since it takes too many steps
    std::vector<MethodTrial> tried_;  ///< the nearest to the goal of each method, errors of the rehearsal
    std::optional<MethodTrial> best_;
};

}  // namespace

MethodChoice choose_method(SpringSystem& system, const RunAhead& run, const ChoiceGoal& goal) {
    return Trials(system, run, goal).choose();
}

}  // namespace orbweaver::mass_spring
