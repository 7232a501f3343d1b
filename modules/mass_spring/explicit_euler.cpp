#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// x += h v, v += h a(x, v), both from the step's start.
class ExplicitEuler final : public Method {
public:
    explicit ExplicitEuler(std::size_t length) : a_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        system.accelerations_at_start(x, v, a_);
        wide_loop(x.size(),
                  [h, x = x.data(), v = v.data(), a = a_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
                      x[i] += h * v[i];
                      v[i] += h * a[i];
                  });
    }

    std::size_t memory_bytes() const noexcept override { return a_.capacity() * sizeof(double); }

private:
    std::vector<double> a_;
};

}  // namespace

std::unique_ptr<Method> make_explicit_euler(std::size_t length) {
    return std::make_unique<ExplicitEuler>(length);
}

}  // namespace orbweaver::mass_spring
