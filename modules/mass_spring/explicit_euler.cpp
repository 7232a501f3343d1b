#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {
namespace {

/// x += h v, v += h a(x, v), both from the step's start.
class ExplicitEuler final : public Method {
public:
    explicit ExplicitEuler(std::size_t length) : a_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) noexcept override {
        system.accelerations(x, v, a_);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += h * v[i];
            v[i] += h * a_[i];
        }
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
