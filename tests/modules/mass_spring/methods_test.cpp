#include "method.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// The error of q'' = -omega^2 q - mu q', q(0) = 1, q'(0) = 0 at t = 1, in q and q'/omega together, against
/// q = e^(-mu t/2) [cos(w t) + mu/(2 w) sin(w t)], q' = -e^(-mu t/2) omega^2/w sin(w t), w^2 = omega^2 -
/// mu^2/4.
double oscillator_error(const MethodInfo& info, int steps) {
    constexpr double kMass = 2, kStiffness = 18, kDamping = 1;
    const double mu = kDamping / kMass;
    const double w = std::sqrt(kStiffness / kMass - mu * mu / 4);
    bodies::Body body = bodies::oscillator(kMass, kStiffness, info.undamped ? 0 : kDamping);
    body.x[1].x = 1.05;  // little enough for strain limits
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, info.undamped ? kDamping : 0, {}});
    Integrator(system, info).advance(body.x, body.v, 1.0 / steps, steps);
    const double exact = std::exp(-mu / 2) * (std::cos(w) + mu / (2 * w) * std::sin(w));
    const double exact_rate = -std::exp(-mu / 2) * (kStiffness / kMass) / w * std::sin(w);
    return std::hypot(body.x[1].x - 1 - 0.05 * exact, (body.v[1].x - 0.05 * exact_rate) / w);
}

}  // namespace

TEST_CASE("methods converge with the order their row says", "[unit]") {
    for (const MethodInfo& info : methods()) {
        INFO(info.name);
        const int steps = info.order > 5   ? 6
                          : info.order > 1 ? 50
                                           : 2000;  // well inside the asymptotic range, above rounding
        const double order = std::log2(oscillator_error(info, steps) / oscillator_error(info, 2 * steps));
        CHECK(order == Approx(info.order).margin(0.1));
    }
}

TEST_CASE("methods ask for the evaluations their row says", "[unit]") {
    class Counter final : public DynamicSystem {
    public:
        std::size_t length() const noexcept override { return 1; }
        void accelerations(std::span<const double>, std::span<const double>,
                           std::span<double> a) noexcept override {
            ++calls;
            a[0] = 0;
        }
        void kick_and_drift(std::span<double>, std::span<double>, double, double) noexcept override { ++calls; }
        double spectral_radius() override { return 1; }
        bool prepare(std::span<const double>, double, double, Tangent) override { return true; }
        void solve(std::span<const double> r, std::span<double> u) override { u[0] = r[0]; }
        double inner_product(std::span<const double> r, std::span<const double> u) const noexcept override {
            return r[0] * u[0];
        }
        void free_accelerations(std::span<const double>, std::span<double> a, double) const noexcept override {
            ++calls;
            a[0] = 0;
        }
        void project_springs(std::span<const double>, std::span<double>, double) const noexcept override {}
        void limit_strain(std::span<double>, double) const noexcept override {}
        mutable int calls = 0;
    };
    for (const MethodInfo& info : methods()) {
        Counter counter;
        std::vector<double> x(1), v(1);
        const auto method = info.make(1);
        method->step(counter, x, v, 1);
        counter.calls = 0;
        method->step(counter, x, v, 1);
        if (info.evaluations > 0)
            CHECK(counter.calls == info.evaluations);
        else
            CHECK(counter.calls > 0);
    }
}

TEST_CASE("methods are found by the name scenes write", "[unit]") {
    std::string names;
    for (const MethodInfo& info : methods()) {
        names += std::string(info.name) + " ";
        REQUIRE(find_method(info.name) == &info);
    }
    CHECK(names ==
          "explicit_euler symplectic_euler verlet rk4 tsit5 srkn6 rkc2 implicit_euler tr_bdf2 provot xpbd ");
    CHECK(find_method("rk5") == nullptr);
    for (const MethodInfo& info : methods()) CHECK(find_method(method_key(info)) == &info);
    CHECK(find_method(std::uint64_t{3}) == nullptr);
    // Saved states hold it: FNV-1a of "a" is the algorithm's published 0xaf63dc4c8601ec8c.
    CHECK(method_key({"a", 1, 0, 1, nullptr}) == 0xaf63dc4c8601ec8c);
}

TEST_CASE("every method follows a free fall", "[unit]") {
    for (const MethodInfo& info : methods()) {
        bodies::Body body;
        body.add({0, 0, 0}, 3);
        SpringSystem system(body.network, nullptr);
        system.set_surroundings({{0, -10, 0}, 0, {}});
        Integrator(system, info).advance(body.x, body.v, 1e-3, 1000);
        CHECK(body.v[0].y == Approx(-10).epsilon(1e-11));  // xpbd reads it off positions
        CHECK(body.x[0].y == Approx(-5).epsilon(info.order > 1 ? 1e-12 : 1.1e-3));  // Euler: g h t/2 off
    }
}
