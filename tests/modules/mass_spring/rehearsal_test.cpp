#include "rehearsal.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kFrame = 0.01;  // s
const WorkLimit kAmple{10, 100000};

/// A wind of 1 uN a particle that begins at 0.5 s and turns round at 1 s.
struct Gust {
    std::vector<Vec3> forces;
    std::span<const Vec3> operator()(double time) {
        const double f = time > 0.995 ? -1e-6 : time > 0.495 ? 1e-6 : 0;
        forces.assign(12, {0, 0, f});
        return forces;
    }
};

struct Trial {
    Body body = bodies::bead_string(10, 5e-3, 1e-6, 1, 1e-3);
    SpringSystem system{body.network, nullptr};
    RunAhead run{{{}, 1e-6, {}}, body.x, Gust{}, kFrame, 200};
    Pace pace{find_method("rk4"), 64};
};

/// After each of the run's frames.
std::vector<Vec3> whole_run(Trial& trial) {
    Rehearsal all(trial.system, trial.run);
    all.take_first(200);
    return all.perform(trial.pace, kAmple)->x;
}

}  // namespace

TEST_CASE("a rehearsal of the first frames is the run", "[unit]") {
    Trial trial;
    const std::vector<Vec3> all = whole_run(trial);
    Integrator integrator(trial.system, *trial.pace.method);
    std::vector<Vec3> x = trial.body.x, v(x.size());
    Gust gust;
    for (int frame = 0; frame < 200; ++frame) {
        trial.system.set_surroundings({{}, 1e-6, gust(frame * kFrame)});
        integrator.advance(x, v, kFrame / 64, 64);
    }
    REQUIRE(all.size() == 200 * x.size());
    CHECK(std::equal(x.begin(), x.end(), all.end() - static_cast<std::ptrdiff_t>(x.size())));
    CHECK(x[5].z != 0);
}

TEST_CASE("the strongest change of the load is rehearsed, from where the run is by then", "[unit]") {
    Trial trial;
    const std::vector<Vec3> all = whole_run(trial);
    Rehearsal rehearsal(trial.system, trial.run);
    rehearsal.take_strongest(30, 200, trial.pace, kAmple);
    CHECK(rehearsal.frames() == 30);
    CHECK(rehearsal.longest_stretch() == 20);
    CHECK(rehearsal.strength_ahead() == 1);
    const auto tried = rehearsal.perform(trial.pace, kAmple);
    REQUIRE(tried);
    const std::size_t n = trial.body.x.size();
    REQUIRE(tried->x.size() == 30 * n);
    CHECK(tried->order == 4);
    CHECK(tried->cost == Approx(trial.system.evaluation_seconds() * 4 * 64));
    // The first ten frames, and those from 90 on: the wind turns at 100. The scout took the same steps.
    CHECK(std::equal(tried->x.begin(), tried->x.begin() + static_cast<std::ptrdiff_t>(10 * n), all.begin()));
    CHECK(std::equal(tried->x.begin() + static_cast<std::ptrdiff_t>(10 * n), tried->x.end(),
                     all.begin() + static_cast<std::ptrdiff_t>(90 * n)));
}

TEST_CASE("what lies beyond the scout is told by its strength", "[unit]") {
    Trial trial;
    Rehearsal rehearsal(trial.system, trial.run);
    rehearsal.take_strongest(12, 90, trial.pace, kAmple);  // sees the wind begin, not turn
    // force and change: 1 + 2 of it against 1 + 1
    CHECK(rehearsal.strength_ahead() == Approx(1.5));
}

TEST_CASE("twins of a stable motion stay together, those of a falling pole part", "[unit]") {
    Trial stable;
    Rehearsal calm(stable.system, stable.run);
    const auto together = calm.take_strongest(12, 100, stable.pace, kAmple);
    REQUIRE(together.size() == 100);
    for (const double times : together) CHECK(times < 10);

    // A mass above its joint falls: what is off grows as exp(sqrt(g/l) t), by 23 in a second.
    Body pole = bodies::oscillator(1, 1e4);
    pole.x[1] = {0, 1, 0};
    SpringSystem system(pole.network, nullptr);
    Rehearsal falling(system, {{{0, -9.81, 0}, 0, {}}, pole.x, {}, kFrame, 1000});
    const auto parted = falling.take_strongest(12, 200, {find_method("rk4"), 8}, kAmple);
    REQUIRE(parted.size() == 200);
    CHECK(parted[199] / parted[99] == Approx(std::exp(std::sqrt(9.81))).epsilon(0.1));
}

TEST_CASE("a rehearsal ends where its limits do, and leaves the surroundings as they were", "[extreme]") {
    Trial trial;
    std::vector<Vec3> wind(12, {1e-6, 0, 0});
    trial.run.surroundings.external = wind;
    {
        Rehearsal rehearsal(trial.system, trial.run);
        rehearsal.take_first(200);
        CHECK_FALSE(rehearsal.perform(trial.pace, {1e-6, 100000}));
        CHECK_FALSE(rehearsal.perform(trial.pace, {10, 63}));
        CHECK(rehearsal.cost_of_a_frame(trial.pace, kAmple) ==
              Approx(4 * 64 * trial.system.evaluation_seconds()));
    }
    CHECK(trial.system.external_force(3) == wind[3]);
}
