#include "method_choice.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "orbweaver/fault.hpp"

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

/// A wind that rises over a second, and turns round at the beginning of others.
class Wind {
public:
    std::span<const Vec3> at(double time) {
        const double second = std::floor(time + 1e-9);
        const double turn = static_cast<int>(second) % 3 == 1 ? 2 : -1;
        const double rise = std::min(1.0, time) * 2e-7;
        forces_.assign(32, {0, 0.5 * turn * rise, rise});
        return forces_;
    }

private:
    std::vector<Vec3> forces_;
};

const Surroundings kAir{{0, -9.81, 0}, 1e-8, {}};

RunAhead run_of(const Body& body, double frames, Wind& wind) {
    return {kAir, body.x, [&wind](double time) { return wind.at(time); }, 1.0 / 60, frames};
}

MethodChoice choose(const Body& body, double tolerance, double budget, double frames = 60,
                    std::int64_t max_substeps = 100000) {
    Wind wind;
    SpringSystem system(body.network, nullptr);
    return choose_method(system, run_of(body, frames, wind), {tolerance, budget, max_substeps});
}

/// Where everything is after each frame of the run.
std::vector<std::vector<Vec3>> motion(Body body, const MethodInfo& method, std::int64_t substeps, int frames) {
    Wind wind;
    SpringSystem system(body.network, nullptr);
    Integrator integrator(system, method);
    std::vector<std::vector<Vec3>> all;
    for (int frame = 0; frame < frames; ++frame) {
        Surroundings surroundings = kAir;
        surroundings.external = wind.at(frame / 60.0);
        system.set_surroundings(surroundings);
        integrator.advance(body.x, body.v, 1 / 60.0 / static_cast<double>(substeps), substeps);
        all.push_back(body.x);
    }
    return all;
}

/// Largest error over the run, against rk4 at `fine` steps a frame.
double error_of(const Body& body, const MethodTrial& trial, int frames = 60, std::int64_t fine = 2048) {
    const auto substeps = static_cast<std::int64_t>(std::llround(1 / 60.0 / trial.step));
    const auto run = motion(body, *trial.method, substeps, frames);
    const auto exact = motion(body, *find_method("rk4"), fine, frames);
    double largest = 0;
    for (std::size_t frame = 0; frame < run.size(); ++frame)
        for (std::size_t i = 0; i < body.x.size(); ++i)
            largest = std::max(largest, distance(run[frame][i], exact[frame][i]));
    return largest;
}

}  // namespace

TEST_CASE("the error that is promised is the run's", "[unit]") {
    Body undamped = thread(0.1);
    for (Spring& s : undamped.network.springs) s.damping = 0;
    struct Case {
        Body body;
        double tolerance;
        int frames;         // of which at most 512 are tried
        std::int64_t fine;  // steps of the reference in a frame
    };
    const Case cases[] = {{thread(0.1), 1e-3, 60, 512}, {thread(0.1), 1e-5, 60, 512},
                          {undamped, 1e-5, 60, 512},    {thread(0.1), 1e-4, 1000, 256},
                          {undamped, 1e-4, 1000, 256},  {thread(1000), 1e-4, 60, 8192}};
    for (const Case& c : cases) {
        const MethodChoice choice = choose(c.body, c.tolerance, 0, c.frames);
        const double error = error_of(c.body, choice.chosen, c.frames, c.fine);
        INFO(choice.sentence);
        CAPTURE(error, c.frames);
        CHECK(choice.chosen.error > error / 3);
        CHECK(choice.chosen.error < 10 * error);
        CHECK(error <= c.tolerance);
    }
}

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
    const MethodChoice soft = choose(thread(0.1), 1e-4, 0);
    INFO(soft.sentence);
    CHECK((soft.chosen.method->evaluations > 1 || soft.chosen.method->name == "symplectic_euler"));
    const MethodChoice stiff = choose(thread(1e6), 1e-4, 0);
    INFO(stiff.sentence);
    CHECK(stiff.meets_goal);
    CHECK((stiff.chosen.method->name == "tr_bdf2" || stiff.chosen.method->name == "implicit_euler"));
}

TEST_CASE("where springs are not damped, little error comes cheapest by kicks and drifts", "[unit]") {
    Body body = thread(0.1);
    for (Spring& s : body.network.springs) s.damping = 0;
    const MethodChoice choice = choose(body, 1e-8, 0);
    INFO(choice.sentence);
    CHECK(choice.chosen.method->name == "srkn6");
    CHECK(choice.meets_goal);
    CHECK(error_of(body, choice.chosen) <= 1e-8);
    CHECK_THAT(choose(thread(0.1), 1e-8, 0).sentence, !Catch::Contains("srkn6"));
}

TEST_CASE("only steps within the most that a frame may take are chosen", "[unit]") {
    const MethodChoice few = choose(thread(0.1), 1e-5, 0, 60, 8);
    INFO(few.sentence);
    CHECK(1 / 60.0 / few.chosen.step < 8.001);
    const MethodChoice one = choose(thread(0.1), 1e-9, 0, 60, 1);
    CHECK(one.chosen.step == 1 / 60.0);
    CHECK_FALSE(one.meets_goal);
    CHECK_THAT(one.sentence,
               Catch::Contains(" comes nearest; max_substeps = 1 leaves out what takes more steps"));
}

TEST_CASE("what no step within the most there may be holds is refused, with the remedy", "[extreme]") {
    // A mass on a spring of 1 m that swings as a pendulum: by one implicit step a second it gains energy.
    const Body body = bodies::oscillator(1, 100);
    SpringSystem system(body.network, nullptr);
    const RunAhead run{{{0, -9.81, 0}, 0, {}}, body.x, {}, 1, 20};
    CHECK(choose_method(system, run, {1e-2, 0, 100000}).meets_goal);
    try {
        choose_method(system, run, {1e-3, 0, 1});
        FAIL("it chose");
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::diverged);
        CHECK(
            std::string(fault.what()) ==
            "nothing that was tried holds with a frame of 1 s in at most 1 steps; allow more by max_substeps");
    }
}

TEST_CASE("of a chaotic run nothing is promised, and the frames that were tried decide", "[unit]") {
    // Two masses that swing below each other, from the side; beside beads at rest, so that trials cost.
    Body body = bodies::bead_string(3000, 5e-3, 1, 1e3, 0);
    const auto joint = body.add({0, 1, 0}, 1, true), one = body.add({1, 1, 0}, 1),
               two = body.add({1.1, 2, 0}, 1);
    body.join(joint, one, 1, 1e4);
    body.join(one, two, 1, 1e4);
    for (std::size_t i = 0; i < body.x.size() - 3; ++i) body.network.fixed[i] = 1;
    SpringSystem system(body.network, nullptr);
    const MethodChoice choice =
        choose_method(system, {{{0, -9.81, 0}, 0, {}}, body.x, {}, 1.0 / 60, 3000}, {0.1, 0, 100000});
    INFO(choice.sentence);
    CHECK_FALSE(choice.meets_goal);
    CHECK(choice.chosen.error > 0.5);  // about as much as it moves
    CHECK_THAT(
        choice.sentence,
        Catch::Contains(" frames that were tried; over the run no method is, since the motion is chaotic"));
    CHECK_THAT(choice.sentence, Catch::Contains(" is the cheapest within 0.1 m over the "));
}

TEST_CASE("the choice is the same each time, and said", "[unit]") {
    const MethodChoice choice = choose(thread(0.1), 1e-4, 0);
    const MethodChoice again = choose(thread(0.1), 1e-4, 0);
    CHECK(choice.sentence == again.sentence);
    CHECK(choice.chosen.step == again.chosen.step);
    CHECK_THAT(choice.sentence, Catch::Contains("a frame) is the cheapest within 0.0001 m; others: "));
}

TEST_CASE("goals that nothing meets are said to be missed", "[extreme]") {
    const MethodChoice cheap = choose(thread(0.1), 0, 1e-12);
    CHECK_FALSE(cheap.meets_goal);
    CHECK_THAT(cheap.sentence, Catch::StartsWith("nothing tried is within 0.001 ns a frame; "));
    Body lone = bodies::oscillator(1, 100);
    lone.x[1] = {1.1, 0, 0};
    SpringSystem system(lone.network, nullptr);
    const MethodChoice exact = choose_method(system, {{}, lone.x, {}, 0.1, 10}, {1e-30, 0, 100000});
    CHECK_FALSE(exact.meets_goal);
    CHECK_THAT(exact.sentence, Catch::StartsWith("nothing tried is within 1e-30 m; "));
}

TEST_CASE("what cannot move has a method too", "[extreme]") {
    Body body = bodies::oscillator(1, 1);
    body.network.fixed[1] = 1;
    SpringSystem system(body.network, nullptr);
    const MethodChoice choice = choose_method(system, {{}, body.x, {}, 0.1, 10}, {1e-6, 0, 100000});
    CHECK(choice.meets_goal);
    CHECK(choice.chosen.error == 0);
}

TEST_CASE("all trials together take two seconds of work at most", "[unit]") {
    const Body body = bodies::bead_string(2000, 5e-3, 1e-8, 10, 1e-4);
    std::vector<Vec3> wind(body.x.size(), {0, 0, 2e-8});
    SpringSystem system(body.network, nullptr);
    const RunAhead run{kAir, body.x, [&](double) { return std::span<const Vec3>(wind); }, 1.0 / 60, 1200};
    const MethodChoice choice = choose_method(system, run, {1e-12, 0, 100000});
    INFO(choice.sentence);
    CHECK_FALSE(choice.meets_goal);
    CHECK(system.work_seconds() > 1);
    CHECK(system.work_seconds() < 2.1);  // a frame more
}

TEST_CASE("what takes too long to be tried is not tried, and that is said", "[extreme]") {
    // Thousands of explicit steps a frame, and a factor of tens of millions of updates for an implicit one.
    const Body body = bodies::lattice(17, 0.1);
    SpringSystem system(body.network, nullptr);
    const MethodChoice choice = choose_method(system, {{}, body.x, {}, 10, 60}, {1e-4, 0, 100000});
    CHECK(
        choice.sentence ==
        "a frame of any method takes too long to be tried; tr_bdf2 in steps of 10 s, which is stable at every "
        "step, is taken untried");
    CHECK_FALSE(choice.meets_goal);
    CHECK(system.work_seconds() < 5);
}
