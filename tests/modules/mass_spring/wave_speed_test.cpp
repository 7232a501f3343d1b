// Waves along a taut thread of tension T and axial stiffness EA, whose strain is e = T/EA. In beads of mass m,
// a apart on springs of rest length r = a/(1 + e) and stiffness k = EA/r, long waves run at
//     lengthwise  c_L = a sqrt(k/m),    crosswise  c_T = sqrt(T a/m),    c_T/c_L = sqrt(T/(k a)) = sqrt(e/(1 +
//     e)),
// which for little strain is sqrt(e). The beads' own dispersion slows a wave of wave number q by (q a)^2/24.
// (A. Fetter and J. Walecka, Theoretical Mechanics of Particles and Continua, sections 24 and 38.)

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr std::size_t kBeads = 399;
constexpr double kSpacing = 1e-3;         // m
constexpr double kWidth = 12;             // spacings, of a Gaussian: (q a)^2/24 is 3e-4
constexpr double kMass = 1e-8;            // kg
constexpr double kAxialStiffness = 0.07;  // N

/// Where the right half of a pulse is that was let go in the middle, m from there: its center of mass.
double way(std::span<const Vec3> x, const std::vector<Vec3>& rest, const Vec3& across) {
    double sum = 0, moment = 0;
    const std::size_t middle = rest.size() / 2;
    for (std::size_t i = middle; i < rest.size(); ++i) {
        const double u = dot(x[i] - rest[i], across);
        sum += u;
        moment += u * kSpacing * static_cast<double>(i - middle);
    }
    return moment / sum;
}

/// m/s, of a small pulse displaced along `direction`; from when its halves have parted until they near the
/// ends.
double measured_speed(double strain, const Vec3& direction, double expected) {
    const double stiffness = kAxialStiffness * (1 + strain) / kSpacing;
    bodies::Body body = bodies::bead_string(kBeads, kSpacing, kMass, stiffness, kAxialStiffness * strain);
    const std::vector<Vec3> rest = body.x;
    const auto middle = static_cast<double>(rest.size() / 2);
    for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
        const double s = (static_cast<double>(i) - middle) / kWidth;
        body.x[i] += direction * (1e-6 * kSpacing * std::exp(-s * s / 2));
    }
    SpringSystem system(body.network, nullptr);
    Integrator integrator(system, *find_method("rk4"));
    const double part = 60 * kSpacing / expected;  // s, five widths and more apart
    const double step = 0.2 * kSpacing / (kSpacing * std::sqrt(stiffness / kMass));
    const auto steps = static_cast<std::int64_t>(std::ceil(part / step));
    integrator.advance(body.x, body.v, part / static_cast<double>(steps), steps);
    const double start = way(body.x, rest, direction);
    integrator.advance(body.x, body.v, part / static_cast<double>(steps), steps);
    return (way(body.x, rest, direction) - start) / part;
}

}  // namespace

TEST_CASE("waves across a thread are slower than waves along it by sqrt(e/(1 + e))", "[unit]") {
    for (const double strain : {0.004, 0.1}) {
        const double along = kSpacing * std::sqrt(kAxialStiffness * (1 + strain) / kSpacing / kMass);
        const double across = std::sqrt(kAxialStiffness * strain * kSpacing / kMass);
        const double measured_along = measured_speed(strain, {1, 0, 0}, along);
        const double measured_across = measured_speed(strain, {0, 0, 1}, across);
        INFO("strain " << strain);
        CHECK(measured_along == Approx(along).epsilon(0.02));
        CHECK(measured_across == Approx(across).epsilon(0.02));
        CHECK(measured_across / measured_along == Approx(std::sqrt(strain / (1 + strain))).epsilon(0.02));
    }
}
