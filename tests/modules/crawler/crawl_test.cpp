#include "crawl.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "crawling_bodies.hpp"
#include "sanitized.hpp"
#include "tbb_workers.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;
using namespace crawling;

namespace {

bool same_bits(std::span<const Vec3> a, std::span<const Vec3> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

}  // namespace

TEST_CASE("a frame run again from where it began ends in the same bits, and is booked once", "[unit]") {
    Setup setup = worm(0.1, 0.1, 0.3);
    setup.build.keeps_volume = true;
    setup.period = 0.5;
    Run run(setup);
    run.advance(0.2);
    const auto x0 = run.x, v0 = run.v, reaction0 = run.reaction;
    run.begin();
    const Books before = run.books();
    mass_spring::Integrator integrator(run.system, *mass_spring::find_method("symplectic_euler"));
    constexpr int kSteps = 400;
    std::vector<Vec3> x, v;
    double work = 0;
    for (const int steps : {kSteps, 13, kSteps}) {  // the second one another way, as error estimates do
        run.x = x0, run.v = v0;
        run.system.begin_frame({});
        integrator.advance(run.x, run.v, setup.frame / kSteps, steps);
        if (steps != kSteps) continue;
        if (!x.empty()) {
            CHECK(same_bits(run.x, x));
            CHECK(same_bits(run.v, v));
            CHECK(run.crawl.work() == work);
        }
        x = run.x, v = run.v, work = run.crawl.work();
    }
    CHECK_FALSE(same_bits(x, x0));
    CHECK(same_bits(run.reaction, reaction0));
    CHECK(run.books().contact == before.contact);
    run.crawl.keep();
    const Books after = run.books();
    CHECK(after.contact > before.contact);
    CHECK(work == Approx(after.muscles - before.muscles - (after.friction - before.friction) -
                         (after.impact - before.impact) - (after.lagging - before.lagging))
                      .epsilon(1e-6));
    CHECK_FALSE(same_bits(run.reaction, reaction0));
    // Once more, from where it began and not from where it ended.
    run.x = x0, run.v = v0;
    run.system.begin_frame({});
    integrator.advance(run.x, run.v, setup.frame / kSteps, kSteps);
    CHECK(same_bits(run.x, x));
}

TEST_CASE("a run that goes on from a saved state ends in the same bits", "[unit]") {
    Setup setup = worm(0.1, 0.1, 0.3);
    setup.period = 0.5;
    Run whole(setup);
    whole.advance(0.2);
    Run again(setup);
    again.x = whole.x, again.v = whole.v, again.frame = whole.frame;
    again.reaction = whole.reaction, again.turned = whole.turned;
    again.step_x = whole.step_x, again.step_v = whole.step_v;
    const Books then = whole.books();
    again.crawl.set_books(then);
    for (int i = 0; i < 6; ++i) {
        whole.advance();
        again.advance();
    }
    CHECK(same_bits(whole.x, again.x));
    CHECK(same_bits(whole.v, again.v));
    CHECK(same_bits(whole.reaction, again.reaction));
    CHECK(whole.books().friction == again.books().friction);
    CHECK(whole.books().impact == again.books().impact);
    CHECK(whole.books().damping == again.books().damping);
}

TEST_CASE("a body goes the same way alone, among others, and whatever threads there are", "[unit]") {
    Setup setup = worm(0.1, 0.1, 0.3);
    setup.build.segments = 7;
    setup.make_springs(5, 1.6, 2e-3);
    setup.build.keeps_volume = true;
    setup.period = 0.3;
    setup.step = 1e-4;  // the advice is for all of them together
    Run alone(setup);
    alone.advance(0.3);
    workers::TbbWorkers threads(3);
    for (const std::uint32_t bodies : {3U, 11U}) {
        setup.bodies = bodies;
        setup.poses.clear();
        // The same place for every other one; the rest elsewhere, turned.
        for (std::uint32_t i = 0; i < bodies; ++i) {
            Pose pose{{0, setup.build.width / 2, 0}, {1, 0, 0}, {0, 1, 0}};
            if (i % 2 == 1) pose = {{3, setup.build.width / 2, 0.1 * i}, {0.6, 0, 0.8}, {0, 1, 0}};
            setup.poses.push_back(pose);
        }
        setup.workers = bodies > 3 ? &threads : nullptr;
        Run together(setup);
        together.advance(0.3);
        for (std::uint32_t i = 0; i < bodies; i += 2) CHECK(same_bits(together.body(i), alone.body()));
        CHECK_FALSE(same_bits(together.body(1), alone.body()));
    }
}

TEST_CASE("a body that is dropped comes to rest on the floor, whichever way up, and its fall is booked",
          "[unit]") {
    const double slant = 0.3, c = std::cos(slant), s = std::sin(slant);
    // Flat, upside down, tail first, and on an edge.
    const Pose poses[] = {{{0, 0.055, 0}, {1, 0, 0}, {0, 1, 0}},
                          {{0, 0.055, 0}, {1, 0, 0}, {0, -1, 0}},
                          {{0, 0.06, 0}, {c, s, 0}, {-s, c, 0}},
                          {{0, 0.06, 0}, {0.6, 0, 0.8}, {0.8 * s, c, -0.6 * s}}};
    for (const Pose& pose : poses) {
        Setup setup = bar();
        setup.friction = {FrictionLaw::coulomb, 0.2, 0.5, 0.4};
        setup.poses = {pose};
        const bool is_flat = pose.forward.x == 1;
        setup.step = 5e-5;
        Run run(setup);
        const double start = run.energy().total();
        const double width = setup.build.width, weight = run.mass() * kG;
        double lowest = 1;
        for (int i = 0; i < repetitions(60); ++i) {
            run.advance();
            lowest = std::min(lowest, run.lowest());
        }
        CHECK(lowest >= -kNear * width * (1 + 1e-9));
        if (kSanitized) continue;
        const mass_spring::Energy end = run.energy();
        CHECK(end.kinetic < 1e-9 * weight * width);
        // Flat on its side, but for what its weight does to springs.
        CHECK(run.center().y == Approx(width / 2).epsilon(0.01));
        const Books books = run.books();
        const double lost = start - end.total();
        CHECK(books.muscles == 0);
        CHECK(books.friction >= 0);
        CHECK(books.friction + books.impact + books.damping == Approx(lost).epsilon(1e-4));
        // The half of a flat bar that is below stops at once, and what is above falls on into the springs: the
        // impact takes half of the energy that fell, and a little more of what comes back.
        if (is_flat) CHECK(books.impact == Approx(lost / 2).epsilon(0.01));
        // The floor bears its weight, and pulls nowhere.
        Vec3 borne;
        for (const Vec3& each : run.reaction) {
            borne += each;
            CHECK(each.y >= 0);
        }
        CHECK(borne.y == Approx(weight).epsilon(1e-3));
        CHECK(norm(across(borne, {0, 1, 0})) < 1e-3 * weight);
        // Two corners of each ring lie on it all the time, and slide no more.
        run.advance(0.1);
        const double points = 2.0 * (setup.build.segments + 1);
        CHECK(run.books().contact - books.contact == Approx(0.1 * points).epsilon(1e-6));
        CHECK(run.books().slip - books.slip < 1e-6 * width * points);
    }
}

TEST_CASE("the books of a fall close wherever frames are cut", "[unit]") {
    constexpr long kSteps = 1200;
    for (const double height : {0.03, 0.0337, 0.051}) {
        Books first;
        for (const long steps : {40, 5, 1}) {
            Setup setup = bar();
            setup.friction = {FrictionLaw::coulomb, 0.2, 0.5, 0.4};
            setup.poses = {{{0, height, 0}, {0.8, 0.6, 0}, {-0.6, 0.8, 0}}};
            setup.step = 2e-4;
            setup.frame = setup.step * static_cast<double>(steps);
            Run run(setup);
            const double start = run.energy().total();
            for (long i = 0; i < repetitions(kSteps / steps); ++i) run.advance();
            if (kSanitized) continue;
            const Books books = run.books();
            const double lost = start - run.energy().total();
            CHECK(books.friction + books.impact + books.damping == Approx(lost).epsilon(1e-3));
            CHECK(books.impact > 0.2 * lost);
            CHECK(run.warnings == 0);
            if (steps == 40) first = books;
            CHECK(books.friction == Approx(first.friction).epsilon(1e-6));
            CHECK(books.impact == Approx(first.impact).epsilon(1e-6));
            CHECK(books.damping == Approx(first.damping).epsilon(1e-6));
        }
    }
}

TEST_CASE("a point that falls on the ground stays there until something lifts it", "[unit]") {
    Setup setup = bar();
    setup.make_springs(3, 1.5, 1);  // so limp that springs do nothing in the time
    setup.poses = {{{0, 0.055, 0}, {1, 0, 0}, {0, 1, 0}}};
    setup.frame = 1e-3;
    Run run(setup);
    while (run.books().contact == 0) run.advance();
    for (int i = 0; i < 4; ++i) {
        run.advance();
        for (std::size_t point = 0; point < run.x.size(); ++point) {
            const bool below = kUp[point % kCorners] < 0;
            if (below) CHECK(std::abs(run.x[point].y) < 1e-5);  // what it fell in the step is 1e-3
            if (below) CHECK(std::abs(run.v[point].y) < 0.02);
            if (!below) CHECK(run.v[point].y == Approx(-std::sqrt(2 * kG * 0.05)).epsilon(0.06));
        }
    }
}

TEST_CASE("without friction nothing moves a body's middle along the ground", "[unit]") {
    const char* gait = GENERATE("rectilinear", "undulation", "sidewinding", "caterpillar");
    Setup setup = worm(0.1, 0, 0);
    setup.build.segments = 10;
    setup.make_springs(5, 1.6, 2e-3);
    setup.gait = gait;
    setup.period = 0.3;
    setup.effort = {0.1, 20, 5, 3};
    setup.friction.sideways = 0;
    Run run(setup);
    run.advance(repetitions(2) * setup.period);
    CHECK(norm(across(run.center(), {0, 1, 0})) < 1e-13);  // 1e4 steps' rounding of 0.1 m and of m/s
    CHECK(run.books().slip > 0.001);
    CHECK(run.books().friction == Approx(0).margin(1e-12 * run.books().muscles));
}

TEST_CASE("a bar on a slope lies still where friction bears it, else slides as Coulomb says", "[unit]") {
    const Friction friction{FrictionLaw::coulomb, 0.2, 0.5, 0.35};
    const char* method = GENERATE("symplectic_euler", "implicit_euler");
    struct Case {
        double along, across, coefficient;
    };
    for (const Case& each : {Case{3, 0, 0.2},
                             {-6, 0, 0.5},
                             {0, 5, 0.35},
                             {0, -5, 0.35},
                             {1.9, 0, 0.2},
                             {-4.7, 0, 0.5},
                             {0, 3.3, 0.35}}) {
        const Setup setup = on_slope(each.along, each.across, friction, method);
        Run run(setup);
        const int frames = 6;
        run.advance(0.2);
        const Vec3 speed = run.velocity(), place = run.center();
        const double slip = run.books().slip, booked = run.books().friction;
        run.advance(frames / 60.0);
        const double pull = std::abs(each.along + each.across), held = each.coefficient * kG;
        const double gained = norm(run.velocity() - speed) / (frames / 60.0);
        const double way = distance(run.center(), place);
        if (pull < held) {
            CHECK(way < 1e-4 * setup.build.width);  // it may lean, not creep
            CHECK(run.books().slip < 0.01 * setup.build.width * 22);
        } else {
            CHECK(gained == Approx(pull - held).epsilon(0.01));
            CHECK(run.books().slip - slip == Approx(22 * way).epsilon(0.01));
            CHECK(run.books().friction - booked == Approx(run.mass() * held * way).epsilon(0.02));
        }
    }
}

TEST_CASE("enormous friction holds a bar on slopes that are steep, along and across", "[unit]") {
    for (const auto& [along, aside] : {std::pair{20.0, 0.0}, {-20.0, 0.0}, {0.0, 8.0}, {4.0, -7.0}}) {
        Setup setup = on_slope(along, aside, {FrictionLaw::coulomb, 1e9, 1e9, 1e9}, "symplectic_euler");
        setup.step = 5e-5;
        Run run(setup);
        run.advance(0.3);  // it leans and trembles first
        const auto start = run.x;
        run.advance(0.1);
        CHECK(largest_distance(run.x, start) < 1e-9);
        CHECK(run.center().y == Approx(setup.build.width / 2).epsilon(0.05));
        CHECK(norm(across(run.center(), {0, 1, 0})) < 0.06 * setup.build.width);  // of leaning
        // What it cost until springs lay still, beside a fall by its width.
        CHECK(std::abs(run.books().friction) < 0.006 * run.mass() * kG * setup.build.width);
    }
}

TEST_CASE("muscles that strain a body held by enormous friction move none of what lies on the ground",
          "[unit]") {
    // So weakly that its weight keeps the held side down.
    Setup setup = worm(2e-4, 1e9, 1e9);
    setup.friction.sideways = 1e9;
    setup.period = 0.3;
    setup.step = 1e-4;
    Run run(setup);
    const auto start = run.x;
    const int periods = repetitions(2);
    run.advance(periods * setup.period);
    CHECK(run.books().contact == Approx(2 * 21 * periods * setup.period).epsilon(1e-9));
    CHECK(run.books().muscles > 0);
    double held = 0, free = 0;
    for (std::size_t i = 0; i < run.x.size(); ++i) {
        const double way = norm(across(run.x[i] - start[i], {0, 1, 0}));
        double& of = start[i].y < 1e-9 ? held : free;
        of = std::max(of, way);
    }
    // In a step a point moves by what the force on it, over its mass, has changed since the last one, times
    // h^2, and stops: from beginning to end by what that came to. Springs pull about as strongly as its weight
    // here.
    const double most = 2 * kG * setup.step * setup.step;
    CHECK(held < most);
    CHECK(free > 1e-6);
    CHECK(std::abs(run.books().friction) < run.mass() * kG * most);
}
