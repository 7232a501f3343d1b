#include "newton_stage.hpp"

#include <algorithm>
#include <cmath>

#include "larger.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

double largest(std::span<const double> values) noexcept {
    double most = 0;
    for (const double value : values) most = larger(most, value);
    return most;
}

}  // namespace

void NewtonStage::look(const Stage& stage, std::span<const double> v) {
    wide_loop(v.size(), [g = stage.g, base = stage.x_base.data(), v = v.data(), x = stage.x.data()](
                            std::size_t i) ORBWEAVER_ALWAYS_INLINE { x[i] = base[i] + g * v[i]; });
    stage.system.accelerations(stage.x, v, residual_);
    wide_loop(v.size(), [g = stage.g, r = residual_.data(), base = stage.v_base.data(), v = v.data()](
                            std::size_t i) ORBWEAVER_ALWAYS_INLINE { r[i] = base[i] + g * r[i] - v[i]; });
}

bool NewtonStage::make_matrix(const Stage& stage, Tangent tangent) {
    const double g = stage.g;
    const bool made = stage.system.prepare(stage.x, g, g * g, tangent);
    made_for_ = made ? g : 0;
    made_of_ = tangent;
    return made;
}

// The exact tangent converges faster where it serves; compressed springs can make it indefinite, which an
// iterative solver finds only when it solves.
bool NewtonStage::find_change(const Stage& stage) {
    const auto solved = [&] {
        stage.system.solve(residual_, change_);
        return std::isfinite(largest(change_));
    };
    if (made_for_ == stage.g || make_matrix(stage, Tangent::exact)) {
        if (solved()) return true;
        if (made_of_ == Tangent::clamped) return false;
    }
    return make_matrix(stage, Tangent::clamped) && solved();
}

double NewtonStage::search_line(const Stage& stage) {
    constexpr int kMostTrials = 10;
    constexpr double kOvershoot = 0.9;
    const double slope = stage.system.inner_product(residual_, change_);
    double length = 1;
    for (int i = 0; i < kMostTrials; ++i) {
        wide_loop(trial_.size(),
                  [length, trial = trial_.data(), v = stage.v.data(), change = change_.data()](std::size_t i)
                      ORBWEAVER_ALWAYS_INLINE { trial[i] = v[i] + length * change[i]; });
        look(stage, trial_);
        const double slope_there = stage.system.inner_product(residual_, change_);
        if (std::abs(slope_there) <= kOvershoot * slope || slope_there == slope) {
            std::copy(trial_.begin(), trial_.end(), stage.v.begin());
            return length;
        }
        const double zero = slope / (slope - slope_there);  // of the slope, were it straight
        length *= zero > 0 && zero < 1 ? std::clamp(zero, 0.1, 0.5) : 0.5;
    }
    return 0;
}

void NewtonStage::take_change(const Stage& stage) {
    wide_loop(stage.v.size(), [v = stage.v.data(), change = change_.data()](std::size_t i)
                                  ORBWEAVER_ALWAYS_INLINE { v[i] += change[i]; });
    look(stage, stage.v);
}

bool NewtonStage::solve(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                        double g, std::span<double> x, std::span<double> v) {
    constexpr int kMost = 40;
    constexpr double kTolerance = 1e-8;  // of the largest velocity
    constexpr double kRounding = 1e-13;  // of the largest coordinate, as a way
    constexpr double kServes = 0.4;      // of the change before: a matrix that is kept
    const Stage stage{system, x_base, v_base, g, x, v};
    look(stage, v);
    double before = 0;
    for (int i = 0; i < kMost && iterations_left_ > 0; ++i, --iterations_left_) {
        const bool fresh = made_for_ != g;
        if (!find_change(stage)) return false;
        // Nothing that a line search could tell from rounding is left: at rest, say.
        if (g * largest(change_) <= kRounding * largest(x)) {
            take_change(stage);
            return true;
        }
        const double length = search_line(stage);
        if (length == 0) {
            made_for_ = 0;
            if (fresh) return false;
            look(stage, v);
            before = 0;
            continue;
        }
        const double change = length * largest(change_);
        if (!std::isfinite(change)) return false;
        // What is left, if the changes go on to shrink as they do.
        const double rate = before > 0 ? change / before : 1;
        const double left = rate < 0.5 ? change * rate / (1 - rate) : change;
        if (length == 1 && (left <= kTolerance * largest(v) || g * left <= kRounding * largest(x))) return true;
        if (length < 1 || (before > 0 && rate > kServes)) made_for_ = 0;
        before = change;
    }
    return false;
}

bool NewtonStage::solve_linearly(DynamicSystem& system, std::span<const double> x_base,
                                 std::span<const double> v_base, double g, std::span<double> x,
                                 std::span<double> v) {
    const Stage stage{system, x_base, v_base, g, x, v};
    std::fill(v.begin(), v.end(), 0.0);
    look(stage, v);
    made_for_ = 0;
    if (!system.prepare(x, g, g * g, Tangent::clamped)) return false;
    system.solve(residual_, v);
    wide_loop(v.size(), [g, base = x_base.data(), v = v.data(), x = x.data()](std::size_t i)
                            ORBWEAVER_ALWAYS_INLINE { x[i] = base[i] + g * v[i]; });
    return true;
}

}  // namespace orbweaver::mass_spring
