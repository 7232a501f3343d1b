#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

std::vector<double> packed(const SpringSystem& system, const std::vector<Vec3>& vectors) {
    std::vector<double> flat(system.length());
    system.packing().pack(vectors, flat);
    return flat;
}

std::vector<Vec3> unpacked(const SpringSystem& system, const std::vector<double>& flat) {
    std::vector<Vec3> vectors(system.size());
    system.packing().unpack(flat, vectors);
    return vectors;
}

}  // namespace

TEST_CASE("what acts freely is gravity, drag and external force", "[unit]") {
    bodies::Body body = bodies::oscillator(2, 100);
    body.x[1].x = 5;  // whatever the spring says
    body.v[1] = {1, 2, 3};
    const std::vector<Vec3> external{{7, 7, 7}, {4, 0, 0}};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -10, 0}, 0.5, external});
    std::vector<double> a(system.length());
    system.free_accelerations(packed(system, body.v), a, 0);
    CHECK(unpacked(system, a)[0] == Vec3{});
    CHECK(distance(unpacked(system, a)[1], {2 - 0.25, -10 - 0.5, -0.75}) < 1e-14);
    // Over 4 s, a' = a(v + 4 a') has drag 0.5/2 of the velocity there: a' = a(v)/(1 + 4 0.5/2).
    system.free_accelerations(packed(system, body.v), a, 4);
    CHECK(distance(unpacked(system, a)[1], {0.875, -5.25, -0.375}) < 1e-14);
}

TEST_CASE("one spring projected once is implicit Euler", "[unit]") {
    // (1 + h c/m + h^2 k/m) v' = v - h k/m (x - r): x' = x + h v'.
    constexpr double kMass = 2, kStiffness = 300, kDamping = 5, kStep = 0.1;
    bodies::Body body = bodies::oscillator(kMass, kStiffness, kDamping);
    body.x[1].x = 1.2;
    body.v[1].x = 0.7;
    SpringSystem system(body.network, nullptr);
    const auto info = find_method("xpbd");
    Integrator(system, *info).advance(body.x, body.v, kStep, 1);
    const double v = (0.7 - kStep * kStiffness / kMass * 0.2) /
                     (1 + kStep * kDamping / kMass + kStep * kStep * kStiffness / kMass);
    CHECK(body.v[1].x == Approx(v).epsilon(1e-12));
    CHECK(body.x[1].x == Approx(1.2 + kStep * v).epsilon(1e-12));
}

TEST_CASE("a spring past the limit is shortened by both its ends, by their masses", "[unit]") {
    bodies::Body body;
    body.add({0, 0, 0}, 1);
    body.add({0, 2, 0}, 3);
    body.join(0, 1, 1, 10);
    const SpringSystem system(body.network, nullptr);
    auto x = packed(system, body.x);
    system.limit_strain(x, 0.1);
    const auto after = unpacked(system, x);
    CHECK(after[0].y == Approx(0.9 * 3 / 4).epsilon(1e-14));
    CHECK(after[1].y == Approx(2 - 0.9 / 4).epsilon(1e-14));
    system.limit_strain(x, 0.2);
    CHECK(bodies::same_bits(unpacked(system, x), after));
}

TEST_CASE("limiting strain leaves springs past the limit behind, as the thesis's figure 5.2 shows", "[unit]") {
    // A strand that gravity would stretch far: one sweep a step shortens springs one by one and stretches their
    // neighbours. 29 particles of 100 ug on springs of 0.01 N/m, 7 mm apart at rest.
    bodies::Body body = bodies::bead_string(29, 7e-3, 1e-7, 0.01, 0);
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 1e-7, {}});
    Integrator provot(system, *find_method("provot"));
    provot.advance(body.x, body.v, 0.5e-3, 4000);
    double worst = 0;
    for (const Spring& s : body.network.springs)
        worst = std::max(worst, distance(body.x[s.a], body.x[s.b]) / s.rest_length - 1);
    CHECK(worst > 0.1 + 1e-6);
    for (const Vec3& x : body.x) CHECK(is_finite(x));
}

TEST_CASE("springs without stiffness, length or free ends are passed over", "[extreme]") {
    bodies::Body body;
    body.add({0, 0, 0}, 1, true);
    body.add({1, 0, 0}, 1, true);
    body.add({1, 0, 0}, 1);
    body.join(0, 1, 0.5, 10);  // both fixed
    body.join(1, 2, 0.5, 10);  // of no length
    body.join(0, 2, 0.5, 0);   // of no stiffness
    const SpringSystem system(body.network, nullptr);
    auto x = packed(system, body.x);
    const auto start = x;
    system.project_springs(start, x, 0.1);
    CHECK(x == start);
}
