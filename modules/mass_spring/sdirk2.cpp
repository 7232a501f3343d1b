#include <algorithm>
#include <limits>

#include "builtin_methods.hpp"
#include "newton_stage.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The singly diagonally implicit Runge-Kutta method of order two that is L-stable (Alexander 1977), with
/// c = 1 - 1/sqrt(2):
///     v1 = v + c h a(x1, v1),                          x1 = x + c h v1,
///     v2 = v + (1 - c) h a(x1, v1) + c h a(x2, v2),    x2 = x + (1 - c) h v1 + c h v2,
/// of which v2 and x2 end the step. Where Newton's method finds no stage, two steps of half the length are
/// taken.
class Sdirk2 final : public Method {
public:
    explicit Sdirk2(std::size_t length)
        : x_(length), v_(length), x_base_(length), v_base_(length), stage_(length) {}

    void begin() noexcept override { stage_.forget(); }

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        halve_until_found(system, x, v, h, 0);
    }

    std::size_t memory_bytes() const noexcept override {
        return 4 * x_.capacity() * sizeof(double) + stage_.memory_bytes();
    }

private:
    void halve_until_found(DynamicSystem& system, std::span<double> x, std::span<double> v, double h,
                           int depth) {
        constexpr int kDeepest = 12;
        if (try_step(system, x, v, h)) return;
        if (depth == kDeepest) {
            // There is no motion to be found: what watches over values is to see that.
            std::fill(v.begin(), v.end(), std::numeric_limits<double>::quiet_NaN());
            return;
        }
        halve_until_found(system, x, v, h / 2, depth + 1);
        halve_until_found(system, x, v, h / 2, depth + 1);
    }

    /// Leaves x and v as they are where it returns false.
    bool try_step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) {
        constexpr double kC = 0.29289321881345247560;  // 1 - 1/sqrt(2)
        const double g = kC * h;
        if (!stage_.solve(system, x, v, g, x_, v_)) return false;
        // h a(x1, v1) = (v1 - v)/c
        const double rest = (1 - kC) * h;
        const double share = (1 - kC) / kC;
        wide_loop(x.size(), [=, x = x.data(), v = v.data(), v1 = v_.data(), xb = x_base_.data(),
                             vb = v_base_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            xb[i] = x[i] + rest * v1[i];
            vb[i] = v[i] + share * (v1[i] - v[i]);
        });
        if (!stage_.solve(system, x_base_, v_base_, g, x_, v_)) return false;
        std::copy(x_.begin(), x_.end(), x.begin());
        std::copy(v_.begin(), v_.end(), v.begin());
        return true;
    }

    std::vector<double> x_, v_;            ///< of a stage
    std::vector<double> x_base_, v_base_;  ///< what the second stage starts from
    NewtonStage stage_;
};

}  // namespace

std::unique_ptr<Method> make_sdirk2(std::size_t length) { return std::make_unique<Sdirk2>(length); }

}  // namespace orbweaver::mass_spring
