#include "stability_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drag_drift.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// q'' + mu q' + omega^2 q = 0 in two independent components, so that one step from q = (1, 0),
/// q' = (0, 1) gives both columns of the one-step matrix.
class Oscillator final : public DynamicSystem {
public:
    Oscillator(double omega, double mu, double radius) noexcept
        : squared_(omega * omega), mu_(mu), radius_(radius) {}
    std::size_t length() const noexcept override { return 2; }
    void accelerations(std::span<const double> x, std::span<const double> v,
                       std::span<double> a) noexcept override {
        for (std::size_t i = 0; i < 2; ++i) a[i] = -squared_ * x[i] - mu_ * v[i];
    }
    // What damps is drag: see MethodInfo::undamped.
    void kick_and_drift(std::span<double> x, std::span<double> v, double kick, double drift) noexcept override {
        const auto dragged = drift_under_drag(mu_, drift);
        for (std::size_t i = 0; i < 2; ++i) {
            v[i] -= kick * squared_ * x[i];
            x[i] += dragged.way * v[i];
            v[i] -= dragged.loss * v[i];
        }
    }
    double spectral_radius() override { return radius_; }
    bool prepare(std::span<const double>, double c, double k, Tangent) override {
        weight_ = 1 + c * mu_ + k * squared_;
        return true;
    }
    void solve(std::span<const double> r, std::span<double> u) override {
        for (std::size_t i = 0; i < 2; ++i) u[i] = r[i] / weight_;
    }
    double inner_product(std::span<const double> r, std::span<const double> u) const noexcept override {
        return r[0] * u[0] + r[1] * u[1];
    }
    // Where nothing swings, what damps is drag.
    void free_accelerations(std::span<const double> v, std::span<double> a, double h) const noexcept override {
        for (std::size_t i = 0; i < 2; ++i) a[i] = squared_ == 0 ? -mu_ * v[i] / (1 + h * mu_) : 0;
    }
    void project_springs(std::span<const double> start, std::span<double> x, double h) const noexcept override {
        if (squared_ == 0) return;
        const double stiffness = squared_ * h * h, damping = mu_ * h;
        for (std::size_t i = 0; i < 2; ++i)
            x[i] -= (stiffness * x[i] + damping * (x[i] - start[i])) / (stiffness + damping + 1);
    }
    void limit_strain(std::span<double>, double) const noexcept override {}  // small motion

private:
    double squared_;
    double mu_;
    double radius_;
    double weight_ = 1;
};

/// Spectral radius <= 1 by the criterion of Schur and Cohn on the one-step matrix, |det| <= 1 and
/// |trace| <= 1 + det, which needs no square root of a cancelling difference.
bool is_stable(Method& method, Oscillator& oscillator, double h) {
    constexpr double kRounding = 1e-14;
    std::array<double, 2> q{1, 0};
    std::array<double, 2> p{0, 1};
    method.begin();
    method.step(oscillator, q, p, h);
    const double determinant = q[0] * p[1] - q[1] * p[0];
    const double trace = q[0] + p[1];
    return std::abs(determinant) <= 1 + kRounding && std::abs(trace) <= 1 + determinant + kRounding;
}

}  // namespace

double stability_limit(const MethodInfo& method, double angular_frequency, double damping_rate,
                       double spectral_radius) {
    constexpr double kFirst = 5e-4;
    constexpr double kLast = 1e6;
    constexpr double kGrowth = 1.05;
    const double rate = std::max(angular_frequency, damping_rate);
    if (rate == 0) return kInfinite;
    const auto stepper = method.make(2);
    Oscillator oscillator(angular_frequency / rate, damping_rate / rate,
                          std::max(rate, spectral_radius) / rate);
    if (!is_stable(*stepper, oscillator, kFirst)) return 0;
    // Too narrow for the scan to find.
    const double resonant =
        method.resonance > 0 && angular_frequency > 0 ? method.resonance * rate / angular_frequency : kInfinite;
    double stable = kFirst;
    while (is_stable(*stepper, oscillator, stable * kGrowth)) {
        stable *= kGrowth;
        if (stable > resonant) return resonant / rate;
        if (stable > kLast) return kInfinite;
    }
    double unstable = stable * kGrowth;
    while (unstable - stable > 1e-9 * stable) {
        const double middle = stable + (unstable - stable) / 2;
        (is_stable(*stepper, oscillator, middle) ? stable : unstable) = middle;
    }
    return std::min(stable, resonant) / rate;
}

}  // namespace orbweaver::mass_spring
