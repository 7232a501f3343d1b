#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// q and q' of q'' + mu q' + omega^2 q = 0.
struct State {
    double q, rate;
};

State operator+(const State& a, const State& b) { return {a.q + b.q, a.rate + b.rate}; }
State operator*(double s, const State& a) { return {s * a.q, s * a.rate}; }

struct Oscillator {
    double omega, mu;  ///< 1/s

    State slope(const State& y) const { return {y.rate, -omega * omega * y.q - mu * y.rate}; }
    /// (I - g J)^-1 y, by Cramer's rule.
    State solve(double g, const State& y) const {
        const double determinant = 1 + g * mu + g * g * omega * omega;
        return {((1 + g * mu) * y.q + g * y.rate) / determinant,
                (y.rate - g * omega * omega * y.q) / determinant};
    }
};

/// |z_q| of z = (I - g J)^-1 e, where e is the difference of TR-BDF2 and of the method of order three on its
/// stages, whose weights are (1 - w)/3, (3 w + 1)/3, d/3 (Hosea and Shampine 1996).
double filtered_error(const Oscillator& body, const State& y, double h) {
    const double d = 1 - std::sqrt(0.5), w = std::sqrt(2.0) / 4, g = d * h;
    const State f1 = body.slope(y);
    const State f2 = body.slope(body.solve(g, y + g * f1));
    const State f3 = body.slope(body.solve(g, y + w * h * (f1 + f2)));
    const State e = h * ((w - (1 - w) / 3) * f1 + (w - (3 * w + 1) / 3) * f2 + (d - d / 3) * f3);
    return std::abs(body.solve(g, e).q);
}

/// A taut strand of 20 beads that swings slowly across itself, on whose stiff springs a wave runs, its
/// neighbours against each other at up to `wave` m/s. The fastest of its modes is of 2e5 rad/s.
Body stiff_strand(double wave) {
    constexpr std::size_t kBeads = 20;
    Body body = bodies::bead_string(kBeads, 0.01, 1e-6, 1e4, 1e-3);
    for (std::size_t i = 1; i <= kBeads; ++i) {
        const double along = static_cast<double>(i) / (kBeads + 1);
        body.v[i] = {i % 2 == 0 ? wave : -wave, 0.01 * std::sin(bodies::kPi * along), 0};
    }
    return body;
}

/// One free particle, for which a matrix is found only for steps of up to `longest` s.
class Fussy final : public DynamicSystem {
public:
    explicit Fussy(double longest) : largest_c_((1 - std::sqrt(0.5)) * longest * (1 + 1e-12)) {}

    std::size_t length() const noexcept override { return 1; }
    void accelerations(std::span<const double>, std::span<const double>,
                       std::span<double> a) noexcept override {
        a[0] = 0;
    }
    void kick_and_drift(std::span<double>, std::span<double>, double, double) noexcept override {}
    double spectral_radius() override { return 1; }
    bool prepare(std::span<const double>, double c, double, Tangent) override { return c <= largest_c_; }
    void solve(std::span<const double> r, std::span<double> u) override { u[0] = r[0]; }
    double inner_product(std::span<const double> r, std::span<const double> u) const noexcept override {
        return r[0] * u[0];
    }
    void free_accelerations(std::span<const double>, std::span<double>, double) const noexcept override {}
    void project_springs(std::span<const double>, std::span<double>, double) const noexcept override {}
    void limit_strain(std::span<double>, double) const noexcept override {}

private:
    double largest_c_;
};

constexpr double kSpan = 0.1;  // s

void run(Body& body, const char* method, double step) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 1e-5, {}});
    const double count = std::ceil(kSpan / step);
    Integrator(system, *find_method(method))
        .advance(body.x, body.v, kSpan / count, static_cast<std::int64_t>(count));
}

ControlledRun run_within(Body& body, double tolerance) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 1e-5, {}});
    return Integrator(system, *find_method("tr_bdf2"))
        .advance_within(body.x, body.v, kSpan, tolerance, 1e-3, 100000);
}

}  // namespace

TEST_CASE("tr_bdf2's error goes through the stage's matrix in position and velocity", "[unit]") {
    constexpr double kStep = 0.01, kMass = 2;
    for (const auto& [omega, damping, drag] :
         {std::tuple(1.0, 0.0, 0.0), {1e5, 0.0, 0.0}, {1e3, 5e3, 0.0}, {1.0, 0.0, 1e5}, {1e3, 10.0, 1e4}}) {
        for (const State& start : {State{3e-3, 0}, State{0, 2e-2}, State{1e-3, -3e-2}}) {
            CAPTURE(omega, damping, drag, start.q, start.rate);
            Body body = bodies::oscillator(kMass, kMass * omega * omega, damping);
            body.x[1].x = 1 + start.q;
            body.v[1].x = start.rate;
            SpringSystem system(body.network, nullptr);
            system.set_surroundings({{}, drag, {}});
            std::vector<double> x(system.length()), v(system.length());
            system.packing().pack(body.x, x);
            system.packing().pack(body.v, v);
            const auto method = find_method("tr_bdf2")->make(system.length());
            method->step(system, x, v, kStep);
            // Newton's method stops at 1e-8 of the velocity.
            const double expected = filtered_error({omega, (damping + drag) / kMass}, start, kStep);
            CHECK(method->error(system) == Approx(expected).epsilon(1e-5));
        }
    }
}

TEST_CASE("stiff modes smaller than the tolerance do not rule tr_bdf2's step", "[unit]") {
    // Amplitude 0.2/2e5 = 1 um, which a step of the slow swing's takes out whole.
    constexpr double kTolerance = 1e-6;
    Body still = stiff_strand(0), waving = stiff_strand(0.2), exact = stiff_strand(0.2);
    const ControlledRun without = run_within(still, kTolerance), with = run_within(waving, kTolerance);
    REQUIRE((without.finished && with.finished));
    CHECK(without.steps < 20);
    CHECK(with.steps < 20);

    run(exact, "rk4", 0.1 / 2e5);
    double farthest = 0;
    for (std::size_t i = 0; i < exact.x.size(); ++i)
        farthest = std::max(farthest, distance(exact.x[i], waving.x[i]));
    CHECK(farthest < with.error);
}

TEST_CASE("parts that tr_bdf2 divides a step into are taken from its budget", "[unit]") {
    // In 32 parts, after 1, 2, 4, 8 and 16 were tried in vain: 62 beyond the step itself.
    const auto method = find_method("tr_bdf2")->make(1);
    Fussy system(1.0 / 32);
    for (const std::int64_t most : {62, 61, 0}) {
        CAPTURE(most);
        StepBudget budget(most);
        std::vector<double> x{0}, v{3};
        method->begin();
        method->use_budget(&budget);
        method->step(system, x, v, 1);
        CHECK(budget.taken() == most);
        CHECK(budget.refused() == (most < 62));
        CHECK(std::isnan(v[0]) == (most < 62));
        if (most == 62) CHECK(x[0] == Approx(3).epsilon(1e-14));
    }
    method->use_budget(nullptr);
    std::vector<double> x{0}, v{3};
    method->begin();
    method->step(system, x, v, 1);
    CHECK(x[0] == Approx(3).epsilon(1e-14));
}
