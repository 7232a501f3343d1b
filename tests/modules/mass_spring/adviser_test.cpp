#include "adviser.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "stability_limit.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

const MethodInfo& method(const char* name) { return *find_method(name); }

Advice advice_for(const Body& body, const char* name, double drag = 0) {
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, drag, {}});
    return advise(system, body.x, method(name));
}

}  // namespace

TEST_CASE("one oscillator is advised by its own frequency and damping", "[unit]") {
    const Body body = bodies::oscillator(0.01, 25, 0.002);
    const Advice advice = advice_for(body, "rk4", 0.001);
    CHECK(advice.angular_frequency == Approx(50).epsilon(1e-9));
    CHECK(advice.damping_rate == Approx(0.3).epsilon(1e-9));
    CHECK(advice.stable_step == Approx(stability_limit(method("rk4"), 50, 0.3)).epsilon(1e-9));
    CHECK(advice.has_spring);
    CHECK(
        advice.sentence ==
        "the largest stable step of rk4 is 56.69 ms, set by a mode of 50 rad/s with a damping rate of 0.3 /s, "
        "strongest in spring 0");
}

TEST_CASE("a chain is advised by its highest mode, 2 sqrt(k/m) sin(n pi/(2 (n + 1)))", "[unit]") {
    const Body body = bodies::bead_string(50, 0.01, 1e-6, 1, 1e-4);
    const double omega = 2 * std::sqrt(1 / 1e-6) * std::sin(50 * bodies::kPi / (2 * 51));
    // Lanczos stops at a residual of 1e-4 of omega^2, so omega is at most 0.5e-4 too low.
    CHECK(advice_for(body, "symplectic_euler").stable_step == Approx(2 / omega).epsilon(1e-4));
}

// Far from the origin springs at rest are strained by rounding, so that bodies as a whole swing by it.
TEST_CASE("a damped body that floats is advised a step of explicit_euler wherever it is", "[unit]") {
    Body body = bodies::lattice(3, 0);
    for (Spring& spring : body.network.springs) spring.damping = 1e-3 * spring.stiffness;
    std::fill(body.network.fixed.begin(), body.network.fixed.end(), 0);
    for (Spring& spring : body.network.springs)
        spring.rest_length = distance(body.x[spring.a], body.x[spring.b]);
    const double here = advice_for(body, "explicit_euler").stable_step;
    REQUIRE(here > 0);
    for (int place = 0; place < 40; ++place) {
        for (Vec3& each : body.x) each += Vec3{0.37, 1.13, -0.71};
        CHECK(advice_for(body, "explicit_euler").stable_step == Approx(here).epsilon(1e-3));
    }
}

TEST_CASE("the adviser names the spring that sets the step", "[unit]") {
    SECTION("the stiff one") {
        Body body = bodies::bead_string(60, 0.01, 1e-6, 1, 1e-4);
        body.network.springs[37].stiffness = 50;
        CHECK(advice_for(body, "rk4").spring == 37);
    }
    SECTION("the one at the lightest mass") {
        Body body = bodies::bead_string(60, 0.01, 1e-6, 1, 1e-4);
        body.network.springs[12].stiffness = 1.5;
        body.network.mass[12] = 1e-9;
        CHECK(advice_for(body, "rk4").spring == 12);
    }
    SECTION("the one with the strongest dashpot") {
        Body body = bodies::bead_string(60, 0.01, 1e-6, 1, 1e-4);
        body.network.springs[20].damping = 0.1;
        const Advice advice = advice_for(body, "rk4");
        CHECK(advice.spring == 20);
        CHECK(advice.damping_rate == Approx(0.2 / 1e-6).epsilon(1e-3));  // c (1/m + 1/m)
    }
}

TEST_CASE("explicit Euler is limited by the mode that is damped least for its frequency", "[unit]") {
    Body body = bodies::oscillator(1, 1e4, 100);  // mu/omega^2 = 10 ms
    body.add({5, 0, 0}, 1);
    body.join(0, 2, 5, 100, 0.1);  // mu/omega^2 = 1 ms, though slower
    const Advice advice = advice_for(body, "explicit_euler");
    CHECK(advice.stable_step == Approx(1e-3).epsilon(1e-3));
    CHECK(advice.spring == 1);
    CHECK(advice_for(body, "rk4").spring == 0);
}

TEST_CASE("explicit Euler has no stable step where a mode is undamped", "[unit]") {
    // Damping along a taut string leaves its swings across undamped.
    Body body = bodies::bead_string(9, 0.01, 1e-6, 1, 1e-3);
    for (Spring& s : body.network.springs) s.damping = 1e-4;
    const Advice advice = advice_for(body, "explicit_euler");
    CHECK(advice.stable_step == 0);
    CHECK(advice.sentence.rfind("no step of explicit_euler is stable: it amplifies a mode of ", 0) == 0);
    // With drag they are damped at k_d/m, and the fastest across sets mu/omega^2.
    const double omega = 2 * std::sqrt(1e-3 / (1e-6 * 0.01)) * std::sin(9 * bodies::kPi / 20);
    CHECK(advice_for(body, "explicit_euler", 1e-6).stable_step == Approx(1 / (omega * omega)).epsilon(2e-3));
}

TEST_CASE("what cannot oscillate takes any step", "[extreme]") {
    Body nothing_free = bodies::oscillator(1, 1);
    nothing_free.network.fixed[1] = 1;
    Body one_alone;
    one_alone.add({0, 0, 0}, 2);
    for (const Body* body : {&nothing_free, &one_alone}) {
        for (const MethodInfo& info : methods()) {
            const Advice advice = advice_for(*body, info.name.data());
            CHECK(std::isinf(advice.stable_step));
            CHECK_FALSE(advice.has_spring);
            CHECK(advice.sentence == "every step of " + std::string(info.name) + " is stable here");
        }
    }
    const Advice slowed = advice_for(one_alone, "rk4", 4);
    CHECK(slowed.stable_step == Approx(2.7852935634052816 * 2 / 4).epsilon(1e-6));
    CHECK_FALSE(slowed.has_spring);
}

TEST_CASE("the thesis's constants put RK4 far past its limit", "[unit]") {
    // 10 ug, 0.01 N/m: about 60 springs at the hub of a full web, each taking half its k along any line.
    constexpr double kMass = 1e-8, kStiffness = 0.01, kThesisStep = 0.02;
    const Advice bare = advice_for(bodies::wheel(60, kMass, kStiffness, 0), "rk4");
    const double omega = std::sqrt((30 + 30 * 0.01) * kStiffness / kMass);  // k n n^T + T/l (I - n n^T) summed
    CHECK(bare.angular_frequency == Approx(omega).epsilon(1e-6));
    CHECK(bare.stable_step == Approx(0.5e-3).epsilon(0.05));
    CHECK(kThesisStep / bare.stable_step == Approx(40).epsilon(0.05));
    const Advice damped = advice_for(bodies::wheel(60, kMass, kStiffness, 1e-5), "rk4");
    CHECK(damped.stable_step < 0.13e-3);
    CHECK(damped.stable_step > 0.08e-3);
}

TEST_CASE("runs at the advised step stay, runs beyond it do not", "[unit]") {
    for (const char* name : {"rk4", "symplectic_euler"}) {
        INFO(name);
        Body body = bodies::bead_string(12, 0.01, 1e-6, 1, 1e-3);
        body.network.springs[4].stiffness = 7;
        body.network.springs[4].rest_length = 0.01 - 1e-3 / 7;
        const Advice advice = advice_for(body, name);
        SpringSystem system(body.network, nullptr);
        const auto grown = [&](double h) {
            auto x = body.x;
            std::vector<Vec3> v(x.size());
            x[5].x += 1e-9;
            Integrator(system, method(name)).advance(x, v, h, 2000);
            return std::abs(x[5].x - body.x[5].x);
        };
        CHECK(grown(0.98 * advice.stable_step) < 1e-6);
        CHECK_FALSE(grown(1.02 * advice.stable_step) < 1e-3);
    }
}
