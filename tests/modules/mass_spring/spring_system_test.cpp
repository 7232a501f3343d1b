#include "spring_system.hpp"

#include <catch2/catch.hpp>

#include "bodies.hpp"
#include "method.hpp"
#include "spring_tangent.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
    return largest;
}

Vec3 momentum(const Body& body) {
    Vec3 sum;
    for (std::size_t i = 0; i < body.x.size(); ++i) sum += body.network.mass[i] * body.v[i];
    return sum;
}

}  // namespace

TEST_CASE("a spring pulls by -[k (|l| - r) + c (dl/dt . l)/|l|] l/|l|", "[unit]") {
    Body body;
    body.add({3, 4, 0}, 2);
    body.add({0, 0, 0}, 4);
    body.join(0, 1, 4.5, 10, 0.5);
    body.v[0] = {1, 0, 2};
    SpringSystem system(body.network, nullptr);
    // |l| = 5, elongation 0.5, dl/dt . l/|l| = 3/5: 10 * 0.5 + 0.5 * 0.6 = 5.3 N along (0.6, 0.8, 0).
    std::vector<Vec3> f(2);
    system.forces(body.x, body.v, f);
    CHECK(distance(f[0], {-5.3 * 0.6, -5.3 * 0.8, 0}) < 1e-14);
    CHECK(f[1] == -f[0]);
    CHECK(tension(body.network.springs[0], body.x) == Approx(5).epsilon(1e-14));

    system.set_surroundings({{0, -10, 0}, 0.25, {}});
    const std::vector<Vec3> a = bodies::accelerations(system, body.x, body.v);
    CHECK(distance(a[0], {(-5.3 * 0.6 - 0.25) / 2, -5.3 * 0.8 / 2 - 10, -0.5 / 2}) < 1e-14);
}

TEST_CASE("forces are accelerations times mass, and fixed particles do not accelerate", "[unit]") {
    // The one adds spring by spring, the other four at a time: a tangle has no two springs in a row, a web has
    // rows of every length.
    Body bent = bodies::ragged_web(0.2);
    bodies::bend(bent);
    for (Body body : {bodies::tangle(40, 0.2), bodies::ragged_web(0.2), bodies::ragged_web(0), bent}) {
        body.network.fixed[7] = 1;
        const std::vector<Vec3> wind(body.v);
        SpringSystem system(body.network, nullptr);
        system.put_on_arms(std::vector<Vec3>(body.x.rbegin(), body.x.rend()));
        system.set_surroundings({{1, -9.81, 2}, 0.3, wind});
        std::vector<Vec3> f(body.x.size());
        system.forces(body.x, body.v, f);
        std::vector<Vec3> a = bodies::accelerations(system, body.x, body.v);
        CHECK(a[7] == Vec3{});
        CHECK(norm(f[7]) > 0);
        f[7] = {};
        for (std::size_t i = 0; i < a.size(); ++i) a[i] *= body.network.mass[i];
        CHECK(largest_difference(f, a) < 1e-12);  // sums of some 10 terms of order 10
    }
}

TEST_CASE("the tangents are the derivatives of the forces", "[unit]") {
    Body body = bodies::tangle(30, 0.4);
    if (GENERATE(false, true)) bodies::bend(body);
    const std::vector<Vec3> u(body.v.rbegin(), body.v.rend());
    SpringSystem system(body.network, nullptr);
    system.put_on_arms(std::vector<Vec3>(body.x.rbegin(), body.x.rend()));
    system.set_surroundings({{}, 0.7, {}});
    const std::size_t n = body.x.size();
    const std::vector<Vec3> still(n);
    constexpr double kStep = 1e-6;  // central differences: error of order 1e-12 plus 1e-16/1e-6
    const auto shifted = [&](const std::vector<Vec3>& from, double step) {
        std::vector<Vec3> to = from;
        for (std::size_t i = 0; i < n; ++i) to[i] += step * u[i];
        return to;
    };
    std::vector<Vec3> ahead(n), behind(n), tangent(n);

    system.forces(shifted(body.x, kStep), still, ahead);
    system.forces(shifted(body.x, -kStep), still, behind);
    SpringTangent(system, body.x).apply(1, 0, u, tangent);
    for (std::size_t i = 0; i < n; ++i) ahead[i] = (behind[i] - ahead[i]) / (2 * kStep);
    CHECK(largest_difference(ahead, tangent) < 1e-6);

    system.forces(body.x, shifted(still, kStep), ahead);
    system.forces(body.x, shifted(still, -kStep), behind);
    SpringTangent(system, body.x).apply(0, 1, u, tangent);
    for (std::size_t i = 0; i < n; ++i) ahead[i] = (behind[i] - ahead[i]) / (2 * kStep);
    CHECK(largest_difference(ahead, tangent) < 1e-6);
}

TEST_CASE("tangents hold fixed particles", "[unit]") {
    Body body = bodies::tangle(10, 0.4);
    body.network.fixed[2] = 1;
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0.7, {}});
    std::vector<Vec3> u(10), out(10);
    u[2] = {1, 1, 1};
    SpringTangent(system, body.x).apply(1, 0, u, out);
    CHECK(largest_difference(out, std::vector<Vec3>(10)) == 0);
    SpringTangent(system, body.x).apply(0, 1, body.v, out);
    CHECK(out[2] == Vec3{});
}

TEST_CASE("a free system keeps its momentum", "[unit]") {
    for (const MethodInfo& info : methods()) {
        INFO(info.name);
        Body body = bodies::tangle(60, 0.05);
        SpringSystem system(body.network, nullptr);
        const Vec3 before = momentum(body);
        Integrator(system, info).advance(body.x, body.v, 1e-3, 1000);
        double scale = 0;
        for (std::size_t i = 0; i < body.x.size(); ++i) scale += body.network.mass[i] * norm(body.v[i]);
        CHECK(distance(before, momentum(body)) < 1e-10 * scale);  // internal forces cancel but for rounding
    }
}

TEST_CASE("an undamped system keeps its energy", "[unit]") {
    Body body = bodies::oscillator(2, 50);
    body.x[1] = {1.1, 0.2, 0};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 0, {}});
    const double before = system.energy(body.x, body.v).total();
    Integrator(system, *find_method("rk4")).advance(body.x, body.v, 1e-3, 4000);
    // RK4 loses (h omega)^6/144 of the energy per step at most: 4000 * (5e-3)^6/144 is below 1e-12.
    CHECK(system.energy(body.x, body.v).total() == Approx(before).epsilon(1e-9));
}

TEST_CASE("a string of beads swings at 2 sqrt(T/(m a)) sin(n pi/40)", "[unit]") {
    constexpr std::size_t kBeads = 19;
    constexpr double kSpacing = 0.01, kMass = 1e-6, kTension = 1e-3, kStiffness = 1;
    Body body = bodies::bead_string(kBeads, kSpacing, kMass, kStiffness, kTension);
    SpringSystem system(body.network, nullptr);
    const auto closed_form = [&](std::size_t n) {
        return 2 * std::sqrt(kTension / (kMass * kSpacing)) *
               std::sin(static_cast<double>(n) * bodies::kPi / 40);
    };
    const auto shape = [](std::size_t n, double amplitude) {
        std::vector<Vec3> u(kBeads + 2);
        for (std::size_t i = 1; i <= kBeads; ++i) {
            u[i].z = amplitude * std::sin(static_cast<double>(n * i) * bodies::kPi / (kBeads + 1));
        }
        return u;
    };

    SECTION("each sine is a mode of the tangent stiffness") {
        for (std::size_t n = 1; n <= kBeads; ++n) {
            const auto u = shape(n, 1);
            std::vector<Vec3> force(u.size());
            SpringTangent(system, body.x).apply(1, 0, u, force);
            const double squared = closed_form(n) * closed_form(n);
            double worst = 0;
            for (std::size_t i = 0; i < u.size(); ++i) {
                worst = std::max(worst, std::abs(force[i].z - kMass * squared * u[i].z));
            }
            CHECK(worst < 1e-10 * kMass * squared);  // exact but for rounding: well within 0.2 %
        }
    }

    SECTION("and swings at that frequency in time") {
        for (const std::size_t n : {std::size_t{1}, std::size_t{7}, std::size_t{19}}) {
            const double omega = closed_form(n);
            constexpr double kSwings = 10;
            const double h = 2e-5;  // omega h < 0.02: RK4's phase error is below 1e-8
            auto x = body.x;
            std::vector<Vec3> v(x.size());
            const auto u = shape(n, 1e-6);  // slopes of 1e-4: the added strain is 1e-8 of a pre-strain of 0.1
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += u[i];
            Integrator rk4(system, *find_method("rk4"));
            double time = 0, last_crossing = 0;
            int crossings = 0;
            while (crossings < 2 * kSwings) {
                const double before = x[1].z;
                rk4.advance(x, v, h, 1);
                time += h;
                if (before * x[1].z >= 0) continue;
                last_crossing = time - h * x[1].z / (x[1].z - before);
                ++crossings;
                REQUIRE(time < 10);
            }
            const double measured = (crossings - 0.5) * bodies::kPi / last_crossing;
            CHECK(measured == Approx(omega).epsilon(0.002));
        }
    }
}

TEST_CASE("a web moves the same however its particles are numbered, by every method", "[unit]") {
    const Body own = bodies::ragged_web(0);
    const Body mixed = bodies::shuffled(own);
    const std::vector<std::uint32_t> to = bodies::shuffle(own.x.size());
    const std::vector<Vec3> wind(own.x.size(), {0, 0, 0.1});
    for (const MethodInfo& method : methods()) {
        CAPTURE(method.name);
        std::vector<Body> runs{own, mixed};
        std::vector<bool> as_numbered;
        for (Body& run : runs) {
            SpringSystem system(run.network, nullptr);
            system.set_surroundings({{0, -9.81, 0}, 0.1, wind});
            Integrator(system, method).advance(run.x, run.v, 1e-3, 100);
            as_numbered.push_back(system.packing().place(5) == 5 && system.packing().place(6) == 6);
        }
        CHECK_FALSE(as_numbered[1]);
        double largest = 0;
        for (std::size_t i = 0; i < to.size(); ++i)
            largest = std::max(largest, distance(runs[0].x[i], runs[1].x[to[i]]));
        CHECK(largest < 1e-9);
        CHECK(distance(runs[0].x[5], own.x[5]) > 1e-3);
    }
}

TEST_CASE("springs that are cut leave the load where it was, whatever the order they are kept in", "[unit]") {
    Body body = bodies::shuffled(bodies::ragged_web(0));
    std::vector<Vec3> wind(body.x.size());
    for (std::size_t i = 0; i < wind.size(); ++i) wind[i] = {static_cast<double>(i), 0, 1};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0, wind});
    const auto before = system.packing();
    body.network.springs.resize(body.network.springs.size() / 3);
    system.network_changed();
    std::size_t moved = 0;
    for (std::size_t i = 0; i < wind.size(); ++i) {
        CHECK(system.external_force(i) == wind[i]);
        moved += before.place(i) != system.packing().place(i) ? 1 : 0;
    }
    CHECK(moved > 0);
    std::vector<Vec3> f(wind.size()), rest(wind.size());
    system.forces(body.x, rest, f);
    std::vector<double> x(system.length()), v(system.length()), a(system.length());
    system.packing().pack(body.x, x);
    system.accelerations(x, v, a);
    std::vector<Vec3> accelerations(wind.size());
    system.packing().unpack(a, accelerations);
    for (std::size_t i = 0; i < wind.size(); ++i) {
        if (body.network.fixed[i] != 0) continue;
        CHECK(distance(accelerations[i], f[i] / body.network.mass[i]) < 1e-9 * (1 + norm(accelerations[i])));
    }
}
