#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The classical Runge-Kutta method of order four (thesis 4.6) for x' = v, v' = a(x, v). Since the stages
/// of x are v plus multiples of earlier accelerations, the whole step is written with the four
/// accelerations alone:
///     x += h v + h^2/6 (a1 + a2 + a3),    v += h/6 (a1 + 2 a2 + 2 a3 + a4).
class Rk4 final : public Method {
public:
    explicit Rk4(std::size_t particles)
        : x_(particles), v_(particles), a1_(particles), a2_(particles), a3_(particles), a4_(particles) {}

    void step(DynamicSystem& system, std::span<Vec3> x, std::span<Vec3> v, double h) noexcept override {
        system.accelerations(x, v, a1_);
        advance_stage(x, v, v, a1_, h / 2);
        system.accelerations(x_, v_, a2_);
        advance_stage(x, v, v_, a2_, h / 2);
        system.accelerations(x_, v_, a3_);
        advance_stage(x, v, v_, a3_, h);
        system.accelerations(x_, v_, a4_);
        finish(x, v, h);
    }

    std::size_t memory_bytes() const noexcept override { return 6 * x_.capacity() * sizeof(Vec3); }

private:
    /// The next stage: x_ = x + h slope, v_ = v + h a. `slope` may be v_ itself.
    void advance_stage(std::span<const Vec3> x, std::span<const Vec3> v, std::span<const Vec3> slope,
                       std::span<const Vec3> a, double h) noexcept {
        const std::size_t count = 3 * x.size();
        const double* x0 = flat(x).data();
        const double* v0 = flat(v).data();
        const double* s = flat(slope).data();
        const double* acceleration = flat(a).data();
        double* xs = flat(std::span<Vec3>(x_)).data();
        double* vs = flat(std::span<Vec3>(v_)).data();
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
            xs[i] = x0[i] + h * s[i];
            vs[i] = v0[i] + h * acceleration[i];
        }
    }

    void finish(std::span<Vec3> x, std::span<Vec3> v, double h) noexcept {
        const std::size_t count = 3 * x.size();
        const double* a1 = flat(std::span<const Vec3>(a1_)).data();
        const double* a2 = flat(std::span<const Vec3>(a2_)).data();
        const double* a3 = flat(std::span<const Vec3>(a3_)).data();
        const double* a4 = flat(std::span<const Vec3>(a4_)).data();
        double* x0 = flat(x).data();
        double* v0 = flat(v).data();
        const double sixth = h / 6;
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
            const double middle = a2[i] + a3[i];
            x0[i] += h * (v0[i] + sixth * (a1[i] + middle));
            v0[i] += sixth * (a1[i] + 2 * middle + a4[i]);
        }
    }

    std::vector<Vec3> x_, v_;
    std::vector<Vec3> a1_, a2_, a3_, a4_;
};

}  // namespace

std::unique_ptr<Method> make_rk4(std::size_t particles) { return std::make_unique<Rk4>(particles); }

}  // namespace orbweaver::mass_spring
