#include "study/refinement.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

double error(const Motion& motion) {
    double largest = 0;
    for (std::size_t i = 0; i < motion.rows(); ++i)
        largest = std::max(largest, std::abs(motion.row(i)[1].x -
                                             0.1 * std::cos(10 * motion.frame_s * static_cast<double>(i))));
    return largest;
}

}  // namespace

TEST_CASE("steps are halved from the longest that divides a frame, tolerances go down tenfold", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    const auto steps = ladder(subject, "rk4", 0.004, 3);
    REQUIRE(steps.size() == 3);
    CHECK(steps[0].step == Approx(0.01 / 3));
    CHECK(steps[1].step == Approx(0.01 / 6));
    CHECK(steps[2].step == Approx(0.01 / 12));
    CHECK(ladder(subject, "rk4", HUGE_VAL, 1)[0].step == 0.01);
    const auto tolerances = ladder(subject, "adaptive", 0, 30);
    REQUIRE(tolerances.size() == 11);  // 1e-3 to the option's least, 1e-13
    CHECK(tolerances.front().tolerance == 1e-3);
    CHECK(tolerances.back().tolerance == Approx(1e-13));
}

TEST_CASE("refinement finds the method's order and, from that, the motion at a step of 0", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    const auto found =
        refine(scene.settings, subject, ladder(subject, "verlet", 0.005, 6), 0.2, 21, scene.deadline);
    REQUIRE(found);
    CHECK(found->rung.step == Approx(0.01 / 64));
    CHECK(found->order == Approx(2).margin(0.01));
    REQUIRE(found->limit);
    // Verlet's error is even in h: what is left behind the second power is of the fourth.
    CHECK(error(found->motion) > 1e-8);
    CHECK(error(*found->limit) < 1e-4 * error(found->motion));
    CHECK(found->change_m == Approx(3 * error(found->motion)).epsilon(0.01));
}

TEST_CASE("refinement stops where rounding does not let it go on", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    const auto found =
        refine(scene.settings, subject, ladder(subject, "rk4", 0.005, 14), 0.2, 21, scene.deadline);
    REQUIRE(found);
    CHECK(found->rung.step > 1e-5);
    CHECK(error(found->motion) < 1e-13);  // thousands of steps, each rounding by up to 1.4e-17 m
}

TEST_CASE("with no time there is no refinement, with little there is some", "[extreme]") {
    OscillatorScene scene("delay = 0.02");
    const Subject subject(scene.settings);
    const auto rungs = ladder(subject, "verlet", 0.01, 10);
    CHECK_FALSE(refine(scene.settings, subject, rungs, 0.2, 21, deadline_in(0.1, scene.interrupt)));
    // A run sleeps 0.4 s: the second rung would not be begun with less than 0.8 s left.
    const auto found = refine(scene.settings, subject, rungs, 0.2, 21, deadline_in(1, scene.interrupt));
    REQUIRE(found);
    CHECK(found->rung.step == 0.01);
    CHECK(std::isinf(found->change_m));
}
