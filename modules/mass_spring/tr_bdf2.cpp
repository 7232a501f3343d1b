#include <algorithm>
#include <limits>

#include "builtin_methods.hpp"
#include "larger.hpp"
#include "newton_stage.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kRootHalf = 0.70710678118654752440;
constexpr double kD = 1 - kRootHalf;
constexpr double kW = kRootHalf / 2;
// Weights of order two less those of order three, of the three stages.
constexpr double kE1 = (4 * kW - 1) / 3;
constexpr double kE2 = -1.0 / 3;
constexpr double kE3 = 2 * kD / 3;

/// TR-BDF2 (Bank and others 1985) as the diagonally implicit Runge-Kutta method that Hosea and Shampine
/// (Analysis and implementation of TR-BDF2, 1996) wrote it as. For y' = f(y), with d = 1 - 1/sqrt(2) and
/// w = sqrt(2)/4,
///     y2 = y + d h [f(y) + f(y2)],    y3 = y + w h [f(y) + f(y2)] + d h f(y3),
/// of which y3 ends the step, and begins the next. Order two, L-stable; a method of order three on the same
/// stages gives the error. Where Newton's method finds no stage, two steps of half the length are taken.
class TrBdf2 final : public Method {
public:
    explicit TrBdf2(std::size_t length)
        : a_(length),
          x_(length),
          v_(length),
          v2_(length),
          x_base_(length),
          v_base_(length),
          error_x_(length),
          error_v_(length),
          stage_(length) {}

    void begin() noexcept override {
        stage_.forget();
        has_slope_ = false;
    }
    void use_budget(StepBudget* budget) noexcept override { budget_ = budget; }

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        constexpr int kMostIterations = 8000;  // of Newton's method, in all parts: two for each of the least
        stage_.allow(kMostIterations);
        halved_ = false;
        // There may be no motion to be found: what watches over values is to see that.
        if (halve_until_found(system, x, v, h, 0)) return;
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        std::fill(v.begin(), v.end(), kNone);
        std::fill(error_x_.begin(), error_x_.end(), kNone);
    }

    /// Stiff parts are taken out of the error e of (x, v) as the method takes them out of the motion: z = (I -
    /// g J)^-1 e with the Jacobian J of x' = v, v' = a. Its position part solves, z_v = (z_x - e_x)/g
    /// eliminated,
    ///     (M + g C + g^2 K) z_x = M (e_x + g e_v) + g C e_x:
    /// the error of x and the way of a step that the error of v makes. Drag and damping are linear in v, so
    /// that g C e_x = g^2 M [a(x, v) - a(x, v + e_x/g)].
    double error(DynamicSystem& system) override {
        if (halved_) return std::numeric_limits<double>::infinity();  // only of its last part is it known
        wide_loop(v_.size(), [g = g_, v = v_.data(), ex = error_x_.data(), shifted = v2_.data()](std::size_t i)
                                 ORBWEAVER_ALWAYS_INLINE { shifted[i] = v[i] + ex[i] / g; });
        std::vector<double>&right = v_base_, &filtered = x_base_;
        system.accelerations(x_, v2_, right);
        wide_loop(right.size(), [g = g_, a = a_.data(), ex = error_x_.data(), ev = error_v_.data(),
                                 r = right.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            r[i] = ex[i] + g * (ev[i] + g * (a[i] - r[i]));
        });
        system.solve(right, filtered);
        double largest = 0;
        for (const double each : filtered) largest = larger(largest, each);
        return largest;
    }

    std::size_t memory_bytes() const noexcept override {
        return 8 * x_.capacity() * sizeof(double) + stage_.memory_bytes();
    }

private:
    /// False, at once, where a half is not found either: the others of its kind would cost as much for nothing.
    bool halve_until_found(DynamicSystem& system, std::span<double> x, std::span<double> v, double h,
                           int depth) {
        constexpr int kDeepest = 12;
        if (depth > 0 && budget_ != nullptr && !budget_->take()) return false;
        if (try_step(system, x, v, h)) return true;
        halved_ = true;
        return depth < kDeepest && halve_until_found(system, x, v, h / 2, depth + 1) &&
               halve_until_found(system, x, v, h / 2, depth + 1);
    }

    /// Leaves x and v as they are where it returns false.
    bool try_step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) {
        g_ = kD * h;
        if (!has_slope_) system.accelerations(x, v, a_);
        has_slope_ = true;
        wide_loop(x.size(), [g = g_, x = x.data(), v = v.data(), a = a_.data(), xb = x_base_.data(),
                             vb = v_base_.data(), v2 = v2_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            xb[i] = x[i] + g * v[i];
            vb[i] = v[i] + g * a[i];
            v2[i] = v[i];
        });
        if (!stage_.solve(system, x_base_, v_base_, g_, x_, v2_)) return false;
        // h f(y2) = (y2 - base)/d
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), a = a_.data(), xb = x_base_.data(),
                             vb = v_base_.data(), v2 = v2_.data(), v3 = v_.data(), ex = error_x_.data(),
                             ev = error_v_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            const double ha = h * a[i];
            const double ha2 = (v2[i] - vb[i]) / kD;
            ex[i] = h * (kE1 * v[i] + kE2 * v2[i]);
            ev[i] = kE1 * ha + kE2 * ha2;
            xb[i] = x[i] + kW * h * (v[i] + v2[i]);
            vb[i] = v[i] + kW * (ha + ha2);
            v3[i] = v2[i];
        });
        if (!stage_.solve(system, x_base_, v_base_, g_, x_, v_)) return false;
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), a = a_.data(), vb = v_base_.data(), x3 = x_.data(),
                             v3 = v_.data(), ex = error_x_.data(), ev = error_v_.data()](std::size_t i)
                                ORBWEAVER_ALWAYS_INLINE {
                                    const double ha3 = (v3[i] - vb[i]) / kD;
                                    ex[i] += h * kE3 * v3[i];
                                    ev[i] += kE3 * ha3;
                                    a[i] = ha3 / h;
                                    x[i] = x3[i];
                                    v[i] = v3[i];
                                });
        return true;
    }

    std::vector<double> a_;                  ///< where the step begins
    std::vector<double> x_, v_, v2_;         ///< of the stages
    std::vector<double> x_base_, v_base_;    ///< what a stage starts from
    std::vector<double> error_x_, error_v_;  ///< of the last step
    NewtonStage stage_;
    StepBudget* budget_ = nullptr;
    double g_ = 0;            ///< s, of the last step
    bool halved_ = false;     ///< the last step was taken in parts
    bool has_slope_ = false;  ///< a_ is that of the state the last step ended in
};

}  // namespace

std::unique_ptr<Method> make_tr_bdf2(std::size_t length) { return std::make_unique<TrBdf2>(length); }

}  // namespace orbweaver::mass_spring
