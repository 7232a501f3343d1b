#include <algorithm>

#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Strain limiting (Provot, Deformation constraints in a mass-spring model, 1995; thesis 5.1): a step of
/// symplectic Euler, after which springs stretched by more than a tenth are shortened to that, one after the
/// other; what that moves changes the velocity too. The result depends on the order of the springs, and
/// correcting one stretches its neighbours: after the sweep there still are springs past the limit (thesis,
/// figure 5.2).
class Provot final : public Method {
public:
    explicit Provot(std::size_t length) : a_(length), before_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        constexpr double kMostStrain = 0.1;
        system.accelerations_at_start(x, v, a_);
        wide_loop(x.size(),
                  [h, x = x.data(), v = v.data(), a = a_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
                      v[i] += h * a[i];
                      x[i] += h * v[i];
                  });
        std::copy(x.begin(), x.end(), before_.begin());
        system.limit_strain(x, kMostStrain);
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), before = before_.data()](std::size_t i)
                                ORBWEAVER_ALWAYS_INLINE { v[i] += (x[i] - before[i]) / h; });
    }

    std::size_t memory_bytes() const noexcept override { return 2 * a_.capacity() * sizeof(double); }

private:
    std::vector<double> a_, before_;
};

}  // namespace

std::unique_ptr<Method> make_provot(std::size_t length) { return std::make_unique<Provot>(length); }

}  // namespace orbweaver::mass_spring
