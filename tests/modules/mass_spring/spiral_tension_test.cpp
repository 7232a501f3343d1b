// How a spiral takes tension off the radii of an orb web. N radii are crossed every b metres by a turn of the
// spiral, closed here so that nothing turns. Stretched outward by u(r), a turn at r is strained by u/r, and its
// two neighbouring pieces pull a radius inward there with 2 f sin(pi/N), f = EA_s u/r; so the radial tension F
// = EA_r u' grows by that from turn to turn,
//     u_i+1 - 2 u_i + u_i-1 = a b^2 u_i/r_i,    a = 2 sin(pi/N) EA_s/(b EA_r),
// and with turns close enough u'' = a u/r, which is solved from the center on by
//     u ~ sqrt(r) I1(2 sqrt(a r)),    F ~ I0(2 sqrt(a r))
// (Bessel's equation in s = 2 sqrt(a r), u = s w; DLMF 10.25.1 and 10.29.4). A spiral that is not closed evens
// out its tension by turning the web, which bends the radii only, and follows this no more.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "settle.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr std::uint32_t kRadii = 33;
constexpr std::uint32_t kTurns = 60;  // inside the rim
constexpr double kSpacing = 1.5e-3;   // m, b
constexpr double kRim = (kTurns + 1) * kSpacing;
constexpr double kRadial = 3e-3;    // N, EA_r
constexpr double kStretch = 1e-5;   // of the rim: strains this small are linear
constexpr double kAccuracy = 0.01;  // turns are not quite close enough: a b is up to 0.19

/// Of the particle on a radius at a turn; turn 0 is the center.
std::uint32_t at(std::uint32_t radius, std::uint32_t turn) {
    return turn == 0 ? 0 : 1 + (turn - 1) * kRadii + radius % kRadii;
}

/// Unstressed as laid, its rim fixed.
bodies::Body laid_web(double spiral_stiffness) {
    bodies::Body body;
    body.add({0, 0, 0}, 1);
    const auto join = [&](std::uint32_t a, std::uint32_t b, double axial_stiffness) {
        const double length = distance(body.x[a], body.x[b]);
        body.join(a, b, length, axial_stiffness / length);
    };
    for (std::uint32_t turn = 1; turn <= kTurns + 1; ++turn) {
        const bool rim = turn == kTurns + 1;
        for (std::uint32_t radius = 0; radius < kRadii; ++radius) {
            const double angle = 2 * bodies::kPi * radius / kRadii, r = kSpacing * turn;
            body.add({r * std::cos(angle), r * std::sin(angle), 0}, 1, rim);
            join(at(radius, turn - 1), at(radius, turn), kRadial);
        }
        for (std::uint32_t radius = 0; radius < kRadii && !rim; ++radius)
            join(at(radius, turn), at(radius + 1, turn), spiral_stiffness);
    }
    return body;
}

}  // namespace

TEST_CASE("a spiral takes tension off the radii as I0(2 sqrt(a r)), and stretches by sqrt(r) I1(2 sqrt(a r))",
          "[unit]") {
    for (const double ratio : {1e-2, 0.1, 1.0}) {
        bodies::Body body = laid_web(ratio * kRadial);
        for (Vec3& x : body.x) x *= 1 + kStretch;
        SpringSystem system(body.network, nullptr);
        REQUIRE(settle(system, body.x).converged);

        const double a = 2 * std::sin(bodies::kPi / kRadii) * ratio / kSpacing;
        const auto s = [&](double r) { return 2 * std::sqrt(a * r); };
        const double scale = kStretch * kRim / (std::sqrt(kRim) * std::cyl_bessel_i(1, s(kRim)));
        double u = 0;
        for (std::uint32_t turn = 1; turn <= kTurns + 1; ++turn) {
            const double before = u, r = kSpacing * turn, middle = r - kSpacing / 2;
            INFO("EA_s/EA_r " << ratio << ", turn " << turn);
            u = norm(body.x[at(5, turn)]) - r;
            CHECK(u == Approx(scale * std::sqrt(r) * std::cyl_bessel_i(1, s(r))).epsilon(kAccuracy));
            CHECK((u - before) / kSpacing ==
                  Approx(scale * std::sqrt(a) * std::cyl_bessel_i(0, s(middle))).epsilon(kAccuracy));
        }
    }
}
