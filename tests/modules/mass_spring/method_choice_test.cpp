#include "method_choice.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// A taut thread that a wind pushes aside; `stiffness` in N/m.
Body thread(double stiffness) {
    Body body = bodies::bead_string(30, 5e-3, 1e-8, stiffness, 1e-4);
    for (Spring& s : body.network.springs) s.damping = 1e-6;
    return body;
}

const std::vector<std::vector<Vec3>>& winds() {
    static const std::vector<std::vector<Vec3>> all = {std::vector<Vec3>(32, {0, 0, 2e-7}),
                                                       std::vector<Vec3>(32, {0, 3e-7, -1e-7})};
    return all;
}

MethodChoice choose(const Body& body, double tolerance, double budget) {
    SpringSystem system(body.network, nullptr);
    return choose_method(system, {{0, -9.81, 0}, 1e-8, {}}, body.x, winds(), {1.0 / 60, 60, tolerance, budget});
}

/// Largest error after a second in the first wind, against steps eight times shorter.
double error_of(const Body& body, const MethodTrial& trial) {
    std::vector<Body> runs{body, body};
    double h = trial.step;
    for (Body& run : runs) {
        SpringSystem system(run.network, nullptr);
        system.set_surroundings({{0, -9.81, 0}, 1e-8, winds()[0]});
        Integrator(system, *trial.method).advance(run.x, run.v, h, std::llround(1 / h));
        h /= 8;
    }
    double largest = 0;
    for (std::size_t i = 0; i < body.x.size(); ++i)
        largest = std::max(largest, distance(runs[0].x[i], runs[1].x[i]));
    return largest;
}

}  // namespace

TEST_CASE("what is chosen for a tolerance keeps it, and a tighter one costs more", "[unit]") {
    const Body body = thread(0.1);
    double before = 0;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        const MethodChoice choice = choose(body, tolerance, 0);
        INFO(choice.sentence);
        CHECK(choice.meets_goal);
        CHECK(error_of(body, choice.chosen) <= tolerance);
        CHECK(choice.chosen.cost >= before);
        before = choice.chosen.cost;
    }
}

TEST_CASE("the more budget, the less error", "[unit]") {
    const Body body = thread(0.1);
    double before = HUGE_VAL;
    for (const double budget : {4e-6, 2e-5, 2e-4}) {
        const MethodChoice choice = choose(body, 0, budget);
        INFO(choice.sentence);
        CHECK(choice.meets_goal);
        CHECK(choice.chosen.cost <= budget);
        CHECK(choice.chosen.error <= before);
        before = choice.chosen.error;
    }
}

TEST_CASE("soft threads are for explicit methods, stiff ones for implicit", "[unit]") {
    CHECK(choose(thread(0.1), 1e-4, 0).chosen.method->name == "rk4");
    const MethodChoice stiff = choose(thread(1e6), 1e-4, 0);
    INFO(stiff.sentence);
    CHECK(stiff.meets_goal);
    CHECK((stiff.chosen.method->name == "tr_bdf2" || stiff.chosen.method->name == "implicit_euler"));
}

TEST_CASE("where springs are not damped, little error comes cheapest by kicks and drifts", "[unit]") {
    Body body = thread(0.1);
    for (Spring& s : body.network.springs) s.damping = 0;
    const MethodChoice choice = choose(body, 1e-7, 0);
    INFO(choice.sentence);
    CHECK(choice.chosen.method->name == "srkn6");
    CHECK(choice.meets_goal);
    CHECK(error_of(body, choice.chosen) <= 1e-7);
    CHECK_THAT(choose(thread(0.1), 1e-7, 0).sentence, !Catch::Contains("srkn6"));
}

TEST_CASE("the choice is the same each time, and said", "[unit]") {
    const MethodChoice choice = choose(thread(0.1), 1e-4, 0);
    const MethodChoice again = choose(thread(0.1), 1e-4, 0);
    CHECK(choice.sentence == again.sentence);
    CHECK(choice.chosen.step == again.chosen.step);
    CHECK_THAT(choice.sentence, Catch::StartsWith("rk4 at ") &&
                                    Catch::Contains("a frame) is the cheapest within 0.0001 m; others: "));
}

TEST_CASE("goals that nothing meets are said to be missed", "[extreme]") {
    const MethodChoice cheap = choose(thread(0.1), 0, 1e-12);
    CHECK_FALSE(cheap.meets_goal);
    CHECK_THAT(cheap.sentence, Catch::StartsWith("nothing tried is within 0.001 ns a frame; "));
    const Body lone = bodies::oscillator(1, 100);
    SpringSystem system(lone.network, nullptr);
    const std::vector<std::vector<Vec3>> pull{{{0, 0, 0}, {1, 0, 0}}};
    const MethodChoice exact = choose_method(system, {}, lone.x, pull, {0.1, 10, 1e-30, 0});
    CHECK_FALSE(exact.meets_goal);
    CHECK_THAT(exact.sentence, Catch::StartsWith("nothing tried is within 1e-30 m; "));
}

TEST_CASE("what cannot move has a method too", "[extreme]") {
    Body body = bodies::oscillator(1, 1);
    body.network.fixed[1] = 1;
    SpringSystem system(body.network, nullptr);
    const MethodChoice choice = choose_method(system, {}, body.x, {}, {0.1, 10, 1e-6, 0});
    CHECK(choice.meets_goal);
    CHECK(choice.chosen.error == 0);
}

TEST_CASE("what takes too long to be tried is not tried, and that is said", "[extreme]") {
    const Body body = bodies::bead_string(500, 5e-3, 1e-8, 10, 1e-4);
    const std::vector<std::vector<Vec3>> loads(6000, std::vector<Vec3>(body.x.size(), {0, 0, 2e-7}));
    SpringSystem system(body.network, nullptr);
    const MethodChoice choice =
        choose_method(system, {{0, -9.81, 0}, 1e-8, {}}, body.x, loads, {1.0 / 60, 60, 1e-4, 0});
    CHECK(choice.sentence ==
          "a frame of any method takes too long to be tried; tr_bdf2 in steps of 16.67 ms, which is stable at "
          "every "
          "step, is taken untried");
    CHECK(!choice.meets_goal);
    CHECK(system.work_seconds() < 5);
}
