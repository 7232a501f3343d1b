#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The classical Runge-Kutta method of order four (thesis 4.6) for x' = v, v' = a(x, v). Since the stages
/// of x are v plus multiples of earlier accelerations, the whole step is written with the four
/// accelerations alone:
///     x += h v + h^2/6 (a1 + a2 + a3),    v += h/6 (a1 + 2 a2 + 2 a3 + a4).
class Rk4 final : public Method {
public:
    explicit Rk4(std::size_t length) : x_(length), v_(length), first_(length), middle_(length), last_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        system.accelerations_at_start(x, v, first_);
        advance_stage(x, v, v, first_, h / 2);
        system.accelerations(x_, v_, middle_);
        advance_stage(x, v, v_, middle_, h / 2);
        system.accelerations(x_, v_, last_);
        advance_stage(x, v, v_, last_, h);
        add_to_middle();
        system.accelerations(x_, v_, last_);
        finish(x, v, h);
    }

    std::size_t memory_bytes() const noexcept override { return 5 * x_.capacity() * sizeof(double); }

private:
    /// The next stage: x_ = x + h slope, v_ = v + h a. `slope` may be v_ itself.
    void advance_stage(std::span<const double> x, std::span<const double> v, std::span<const double> slope,
                       std::span<const double> a, double h) noexcept {
        wide_loop(x.size(), [=, xs = x_.data(), vs = v_.data(), x = x.data(), v = v.data(),
                             slope = slope.data(), a = a.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            xs[i] = x[i] + h * slope[i];
            vs[i] = v[i] + h * a[i];
        });
    }

    void add_to_middle() noexcept {
        wide_loop(middle_.size(), [middle = middle_.data(), last = last_.data()](std::size_t i)
                                      ORBWEAVER_ALWAYS_INLINE { middle[i] += last[i]; });
    }

    void finish(std::span<double> x, std::span<double> v, double h) noexcept {
        const double sixth = h / 6;
        wide_loop(x.size(), [=, x = x.data(), v = v.data(), first = first_.data(), middle = middle_.data(),
                             last = last_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            x[i] += h * (v[i] + sixth * (first[i] + middle[i]));
            v[i] += sixth * (first[i] + 2 * middle[i] + last[i]);
        });
    }

    std::vector<double> x_, v_;   ///< of a stage
    std::vector<double> first_;   ///< a1
    std::vector<double> middle_;  ///< a2, then a2 + a3
    std::vector<double> last_;    ///< a3, then a4
};

}  // namespace

std::unique_ptr<Method> make_rk4(std::size_t length) { return std::make_unique<Rk4>(length); }

}  // namespace orbweaver::mass_spring
