#include "spectral_bound.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver::mass_spring;

TEST_CASE("a lone spring's bound is its own frequency and damping", "[unit]") {
    const SpectralBound bound = bound_spectrum(bodies::oscillator(0.01, 25, 0.02).network, 0.05);
    CHECK(bound.angular_frequency == Approx(50).epsilon(1e-9));
    CHECK(bound.damping_rate == Approx((0.02 + 0.05) / 0.01).epsilon(1e-9));
}

TEST_CASE("a thread's bound is its highest mode along it, 2 sqrt(k/m) sin(n pi/(2 (n + 1)))", "[unit]") {
    const double omega = 2 * std::sqrt(1 / 1e-6) * std::sin(30 * bodies::kPi / 62);
    const SpectralBound bound = bound_spectrum(bodies::bead_string(30, 0.01, 1e-6, 1, 1e-3).network, 0);
    CHECK(bound.angular_frequency >= omega);
    CHECK(bound.angular_frequency == Approx(omega).epsilon(0.01));  // power iteration has not quite ended
    CHECK(bound.damping_rate == 0);
}

TEST_CASE("what cannot move has no modes", "[unit]") {
    bodies::Body held = bodies::oscillator(1, 1, 1);
    held.network.fixed[1] = 1;
    const SpectralBound bound = bound_spectrum(held.network, 1);
    CHECK(bound.angular_frequency == 0);
    CHECK(bound.damping_rate == 0);
}
