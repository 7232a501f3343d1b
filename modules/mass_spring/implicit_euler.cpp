#include <algorithm>
#include <limits>

#include "builtin_methods.hpp"
#include "newton_stage.hpp"

namespace orbweaver::mass_spring {
namespace {

/// Linearly implicit Euler (Baraff and Witkin, Large steps in cloth simulation, 1998): one Newton step of
///     v' = v + h a(x', v'),    x' = x + h v'
/// from where the step begins: (M + h C + h^2 K) v' = M v + h f(x, 0). Linearly stable at every step; damps
/// what it cannot follow.
class ImplicitEuler final : public Method {
public:
    explicit ImplicitEuler(std::size_t length) : start_x_(length), start_v_(length), stage_(length) {}

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        std::copy(x.begin(), x.end(), start_x_.begin());
        std::copy(v.begin(), v.end(), start_v_.begin());
        // Past what rounding leaves of the matrix there is no step: what watches over values is to see that.
        if (!stage_.solve_linearly(system, start_x_, start_v_, h, x, v))
            std::fill(v.begin(), v.end(), std::numeric_limits<double>::quiet_NaN());
    }

    std::size_t memory_bytes() const noexcept override {
        return 2 * start_x_.capacity() * sizeof(double) + stage_.memory_bytes();
    }

private:
    std::vector<double> start_x_, start_v_;
    NewtonStage stage_;
};

}  // namespace

std::unique_ptr<Method> make_implicit_euler(std::size_t length) {
    return std::make_unique<ImplicitEuler>(length);
}

}  // namespace orbweaver::mass_spring
