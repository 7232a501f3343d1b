#include "study/conditioning.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

TEST_CASE("only what is free to move is displaced, each by the length asked", "[unit]") {
    OscillatorScene scene("growth = 30");
    const Subject subject(scene.settings);
    const auto offsets = free_offsets(scene.settings, subject, {"rk4", 0.001, 0}, 1e-10, scene.deadline);
    REQUIRE(offsets.size() == 4);
    CHECK(offsets[0] == Vec3{});
    CHECK(norm(offsets[1]) == Approx(1e-10));
    CHECK(norm(offsets[2]) == Approx(1e-10));
    CHECK(norm(offsets[1] - offsets[2]) > 1e-12);
}

TEST_CASE("twins of an unstable place part as cosh does, and the horizon is where 1e-10 m became 1e-6",
          "[unit]") {
    const double growth = 80;  // 1/s: cosh(80 t) = 1e4 at 0.1238 s
    OscillatorScene scene("growth = 80");
    const Subject subject(scene.settings);
    TrialPlan plan{subject.overrides({"rk4", 1e-4, 0}), 0.2};
    const Trial trial = run_trial(scene.settings, subject, plan, scene.deadline);
    plan.offsets = free_offsets(scene.settings, subject, {"rk4", 1e-4, 0}, kDisplacement, scene.deadline);
    const Trial twin = run_trial(scene.settings, subject, plan, scene.deadline);
    const Conditioning found = judge(trial.motion, twin.motion);
    REQUIRE(found.deviation_m.size() == 21);
    // The displaced place is the origin, so that not even rounding comes in between; rk4 adds (80 h)^4/120 a
    // time.
    for (std::size_t i = 0; i < 21; ++i)
        CHECK(found.deviation_m[i] ==
              Approx(1e-10 * std::cosh(growth * 0.01 * static_cast<double>(i))).epsilon(1e-6));
    CHECK_FALSE(found.whole);
    CHECK(found.horizon_rows == 13);  // rows 0 to 12, the last at 0.12 s
    CHECK(found.horizon_s == Approx(0.12));
    CHECK_THAT(sentence(found), Catch::Contains("has grown past 1e-06 m after 120 ms"));
}

TEST_CASE("twins that stay together have the whole run as their horizon", "[unit]") {
    Motion motion{1, 0.1, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
    Motion twin = motion;
    twin.positions[2].y = 1e-7;
    const Conditioning found = judge(motion, twin);
    CHECK(found.whole);
    CHECK(found.horizon_rows == 3);
    CHECK(found.horizon_s == Approx(0.2));
    CHECK_THAT(sentence(found), Catch::Contains("over the whole run"));
}

TEST_CASE("a horizon before the first frame is the first frame", "[extreme]") {
    Motion motion{1, 0.1, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
    Motion twin = motion;
    twin.positions[1].y = std::nan("");
    CHECK(judge(motion, twin).horizon_rows == 2);
}
