#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {
namespace {

/// v += h a(x, v), then x += h v with the new velocity.
class SymplecticEuler final : public Method {
public:
    explicit SymplecticEuler(std::size_t particles) : a_(particles) {}

    void step(DynamicSystem& system, std::span<Vec3> x, std::span<Vec3> v, double h) noexcept override {
        system.accelerations(x, v, a_);
        for (std::size_t i = 0; i < x.size(); ++i) {
            v[i] += h * a_[i];
            x[i] += h * v[i];
        }
    }

    std::size_t memory_bytes() const noexcept override { return a_.capacity() * sizeof(Vec3); }

private:
    std::vector<Vec3> a_;
};

}  // namespace

std::unique_ptr<Method> make_symplectic_euler(std::size_t particles) {
    return std::make_unique<SymplecticEuler>(particles);
}

}  // namespace orbweaver::mass_spring
