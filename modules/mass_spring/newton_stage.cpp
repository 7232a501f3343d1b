#include "newton_stage.hpp"

#include <algorithm>
#include <cmath>

#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

double largest(std::span<const double> values) noexcept {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

/// x = x_base + g v
void follow(std::span<const double> x_base, std::span<const double> v, double g, std::span<double> x) noexcept {
    wide_loop(x.size(), [g, base = x_base.data(), v = v.data(), x = x.data()](std::size_t i)
                            ORBWEAVER_ALWAYS_INLINE { x[i] = base[i] + g * v[i]; });
}

}  // namespace

double NewtonStage::improve(DynamicSystem& system, std::span<const double> x_base,
                            std::span<const double> v_base, double g, std::span<double> x,
                            std::span<double> v) {
    system.accelerations(x, v, a_);
    wide_loop(v.size(), [g, r = residual_.data(), base = v_base.data(), a = a_.data(), v = v.data()](
                            std::size_t i) ORBWEAVER_ALWAYS_INLINE { r[i] = base[i] + g * a[i] - v[i]; });
    system.solve(residual_, change_);
    wide_loop(v.size(), [v = v.data(), change = change_.data()](std::size_t i)
                            ORBWEAVER_ALWAYS_INLINE { v[i] += change[i]; });
    follow(x_base, v, g, x);
    return largest(change_);
}

bool NewtonStage::iterate(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                          double g, std::span<double> x, std::span<double> v) {
    constexpr int kMost = 12;
    constexpr double kTolerance = 1e-10;  // of the largest velocity
    constexpr double kRounding = 1e-13;   // of the largest coordinate, as a way
    constexpr double kSlow = 0.5;         // of the change before: a matrix that serves no longer
    double before = 0;
    for (int i = 0; i < kMost; ++i) {
        const double change = improve(system, x_base, v_base, g, x, v);
        if (change <= kTolerance * largest(v) || g * change <= kRounding * largest(x)) return true;
        if (!std::isfinite(change) || (i > 1 && change > kSlow * before)) return false;
        before = change;
    }
    return false;
}

bool NewtonStage::solve(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                        double g, std::span<double> x, std::span<double> v) {
    const auto guess = [&](double share) {
        for (std::size_t i = 0; i < v.size(); ++i) v[i] = share * v_base[i];
        follow(x_base, v, g, x);
    };
    if (made_for_ == g) {
        guess(1);
        if (iterate(system, x_base, v_base, g, x, v)) return true;
    }
    // At rest the springs are as they were; where they would be without forces they may be stretched past use.
    for (const double share : {1.0, 0.0}) {
        guess(share);
        made_for_ = system.prepare(x, g, g * g) ? g : 0;
        if (made_for_ == g && iterate(system, x_base, v_base, g, x, v)) return true;
    }
    return false;
}

void NewtonStage::solve_linearly(DynamicSystem& system, std::span<const double> x_base,
                                 std::span<const double> v_base, double g, std::span<double> x,
                                 std::span<double> v) {
    std::fill(v.begin(), v.end(), 0.0);
    follow(x_base, v, g, x);
    made_for_ = system.prepare(x, g, g * g) ? g : 0;
    improve(system, x_base, v_base, g, x, v);
}

}  // namespace orbweaver::mass_spring
