#include <algorithm>

#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Extended position-based dynamics with small steps (Macklin, Mueller and Chentanez 2016; Macklin and others
/// 2019): fall freely to x', let each spring in turn correct it once, and read the velocity off,
///     x' = x + h v + h^2 a,    x' += corrections,    v' = (x' - x)/h.
/// A step holds at any stiffness; what one sweep does not reach is missing from the motion, which is softer and
/// more damped the longer the step.
class Xpbd final : public Method {
public:
    explicit Xpbd(std::size_t length) : start_(length), a_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        std::copy(x.begin(), x.end(), start_.begin());
        system.free_accelerations(v, a_, h);
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), a = a_.data()](std::size_t i)
                                ORBWEAVER_ALWAYS_INLINE { x[i] += h * (v[i] + h * a[i]); });
        system.project_springs(start_, x, h);
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), start = start_.data()](std::size_t i)
                                ORBWEAVER_ALWAYS_INLINE { v[i] = (x[i] - start[i]) / h; });
    }

    std::size_t memory_bytes() const noexcept override { return 2 * a_.capacity() * sizeof(double); }

private:
    std::vector<double> start_, a_;
};

}  // namespace

std::unique_ptr<Method> make_xpbd(std::size_t length) { return std::make_unique<Xpbd>(length); }

}  // namespace orbweaver::mass_spring
