#include "motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

constexpr double kResponse = 0.15, kTime = 0.3;  // s
const Vec3 kWanted{0.1, 0, 0.05};                // m/s

struct End {
    Vec3 position, velocity;
};

End run(MotionMethod method, int steps, double top_speed = 10, double strength = 100) {
    const double dt = kTime / steps;
    Agent agent{{}, {}, {0, 1, 0}, top_speed};
    for (int i = 0; i < steps; ++i) {
        const Motion motion = moved(method, agent, kWanted, kResponse, strength, dt);
        agent.position += dt * motion.way;
        agent.velocity = motion.velocity;
    }
    return {agent.position, agent.velocity};
}

/// From rest, v = w (1 - e^(-t/T)), x = w (t - T (1 - e^(-t/T))).
End exact() {
    const double share = 1 - std::exp(-kTime / kResponse);
    return {(kTime - kResponse * share) * kWanted, share * kWanted};
}

}  // namespace

TEST_CASE("methods of motion converge to the closed form by their orders", "[unit]") {
    struct Case {
        const char* name;
        double order;
    };
    for (const Case& c : {Case{"euler", 1}, Case{"midpoint", 2}, Case{"rk4", 4}}) {
        CAPTURE(c.name);
        const MotionMethod method = find_motion_method(c.name);
        const End coarse = run(method, 16), fine = run(method, 32);
        CHECK(std::log2(distance(coarse.velocity, exact().velocity) /
                        distance(fine.velocity, exact().velocity)) == Approx(c.order).margin(0.15));
        CHECK(std::log2(distance(coarse.position, exact().position) /
                        distance(fine.position, exact().position)) == Approx(c.order).margin(0.15));
    }
}

TEST_CASE("no method goes faster than the top speed, or is stronger than it may be", "[unit]") {
    for (const MotionMethod method : {MotionMethod::euler, MotionMethod::midpoint, MotionMethod::rk4}) {
        CHECK(norm(run(method, 20, 0.05).velocity) == Approx(0.05));
        CHECK(norm(run(method, 20, 10, 0.1).velocity) <= 0.1 * kTime * (1 + 1e-12));
    }
}
