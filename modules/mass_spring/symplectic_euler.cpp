#include "builtin_methods.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Semi-implicit Euler (de Vogelaere 1956; Cromer 1981): v += h a(x, v), then x += h v with the new velocity.
class SymplecticEuler final : public Method {
public:
    explicit SymplecticEuler(std::size_t length) : a_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        system.accelerations_at_start(x, v, a_);
        wide_loop(x.size(),
                  [h, x = x.data(), v = v.data(), a = a_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
                      v[i] += h * a[i];
                      x[i] += h * v[i];
                  });
    }

    std::size_t memory_bytes() const noexcept override { return a_.capacity() * sizeof(double); }

private:
    std::vector<double> a_;
};

}  // namespace

std::unique_ptr<Method> make_symplectic_euler(std::size_t length) {
    return std::make_unique<SymplecticEuler>(length);
}

}  // namespace orbweaver::mass_spring
