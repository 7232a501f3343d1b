#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Velocity Verlet (Swope and others 1982),
///     x += h v + h^2/2 a(x, v),    v += h/2 [a(x, v) + a(x', v + h a(x, v))],
/// whose second evaluation sees the velocity that the first predicts, so that it is of order two under damping
/// too.
class VelocityVerlet final : public Method {
public:
    explicit VelocityVerlet(std::size_t length) : first_(length), second_(length), predicted_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        system.accelerations_at_start(x, v, first_);
        wide_loop(x.size(), [h, x = x.data(), v = v.data(), a = first_.data(),
                             p = predicted_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            x[i] += h * (v[i] + h / 2 * a[i]);
            p[i] = v[i] + h * a[i];
        });
        system.accelerations(x, predicted_, second_);
        wide_loop(x.size(), [h, v = v.data(), a = first_.data(), b = second_.data()](std::size_t i)
                                ORBWEAVER_ALWAYS_INLINE { v[i] += h / 2 * (a[i] + b[i]); });
    }

    std::size_t memory_bytes() const noexcept override { return 3 * first_.capacity() * sizeof(double); }

private:
    std::vector<double> first_, second_, predicted_;
};

}  // namespace

std::unique_ptr<Method> make_verlet(std::size_t length) { return std::make_unique<VelocityVerlet>(length); }

}  // namespace orbweaver::mass_spring
