#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {
namespace {

/// x += h v, v += h a(x, v), both from the step's start.
class ExplicitEuler final : public Method {
public:
    explicit ExplicitEuler(std::size_t particles) : a_(particles) {}

    void step(DynamicSystem& system, std::span<Vec3> x, std::span<Vec3> v, double h) noexcept override {
        system.accelerations(x, v, a_);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += h * v[i];
            v[i] += h * a_[i];
        }
    }

    std::size_t memory_bytes() const noexcept override { return a_.capacity() * sizeof(Vec3); }

private:
    std::vector<Vec3> a_;
};

}  // namespace

std::unique_ptr<Method> make_explicit_euler(std::size_t particles) {
    return std::make_unique<ExplicitEuler>(particles);
}

}  // namespace orbweaver::mass_spring
