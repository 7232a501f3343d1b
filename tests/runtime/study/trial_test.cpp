#include "study/trial.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/opened_scene.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

TEST_CASE("a trial gives the motion, its cost and what the module says of itself", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    const Trial trial =
        run_trial(scene.settings, subject, {subject.overrides({"rk4", 1e-4, 0}), 0.2}, scene.deadline);
    CHECK(trial.ending == Ending::done);
    CHECK(trial.motion.particles == 4);
    REQUIRE(trial.motion.rows() == 21);
    CHECK(trial.motion.frame_s == 0.01);
    CHECK(trial.motion.energy_j.size() == 20);
    CHECK(trial.motion.energy_j.back() == Approx(0.5));  // omega^2 A^2/2
    CHECK(trial.steps == 2000);
    CHECK(trial.stable_step_s == Approx(std::sqrt(8.0) / 10));
    CHECK(trial.wall_s > 0);
    CHECK(trial.elapsed_s > trial.wall_s);
    // x = A cos(omega t); fourth order at 1e-3 of a radian leaves 1e-14 of the amplitude.
    CHECK(trial.motion.row(20)[1].x == Approx(0.1 * std::cos(2.0)).margin(1e-13));
}

TEST_CASE("the scene's own tolerance is left out unless the study asks for one", "[unit]") {
    OscillatorScene scene("tolerance = 0.04");
    const Subject subject(scene.settings);
    const auto steps = [&](const Rung& rung) {
        return run_trial(scene.settings, subject, {subject.overrides(rung), 0.01}, scene.deadline).steps;
    };
    // sqrt(sqrt(tolerance))/omega: by default, 1 um, 3.2 ms; at 0.1 nm, 0.32 ms; at the scene's 0.04 m, a
    // frame.
    CHECK(steps({"adaptive", 0, 0}) == 4);
    CHECK(steps({"adaptive", 0, 1e-10}) == 32);
}

TEST_CASE("several instances are watched as one body", "[unit]") {
    OscillatorScene scene;
    scene.folder.write("scene.toml",
                       "[scene]\nduration = 0.2\nstep = 0.01\n[[oscillator]]\n[[oscillator]]\nomega = 20\n");
    const Subject subject(scene.settings);
    const Trial trial =
        run_trial(scene.settings, subject, {subject.overrides({"verlet", 0.005, 0}), 0.1}, scene.deadline);
    CHECK(trial.motion.particles == 8);
    CHECK(trial.stable_step_s == Approx(2.0 / 20));
    CHECK(trial.motion.energy_j.size() == 10);
}

TEST_CASE("displacements are added before the first frame", "[unit]") {
    OscillatorScene scene;
    const Subject subject(scene.settings);
    const TrialPlan plan{
        subject.overrides({"rk4", 0.01, 0}), 0, {{0, 0, 0}, {0, 1e-3, 0}, {0, 0, 2}, {0, 0, 0}}};
    const Trial trial = run_trial(scene.settings, subject, plan, scene.deadline);
    REQUIRE(trial.motion.rows() == 1);
    CHECK(trial.motion.row(0)[1] == Vec3{0.1, 1e-3, 0});
    CHECK(trial.motion.row(0)[2] == Vec3{0, 0, 2});
}

TEST_CASE("however a trial ends, it says so", "[extreme]") {
    OscillatorScene scene("omega = 1000");
    const Subject subject(scene.settings);
    const auto run = [&](std::vector<std::string> overrides, double seconds) {
        return run_trial(scene.settings, subject, {std::move(overrides), 0.2},
                         deadline_in(seconds, scene.interrupt));
    };
    const auto as_asked = subject.overrides({"verlet", 0.01, 0});
    CHECK(run(as_asked, 60).ending == Ending::diverged);
    CHECK_THAT(run(as_asked, 60).message, Catch::Contains("take a smaller step"));
    CHECK(run(as_asked, 0).ending == Ending::timeout);
    auto stopping = as_asked;
    stopping.push_back("oscillator.on_unstable=stop");
    CHECK(run(stopping, 60).ending == Ending::refused);
    auto far = subject.overrides({"explicit", 0.01, 0});
    far.push_back("oscillator.bystander=200");
    CHECK(run(far, 60).ending == Ending::refused);
    CHECK(kind_of_fault([&] { run({"oscillator.step=-1"}, 60); }) == FaultKind::invalid);
    CHECK(kind_of_fault([&] {
              run_trial(scene.settings, subject, {as_asked, 1e5}, scene.deadline);
          }) == FaultKind::limit);
}

TEST_CASE("a scene that is invalid as it is ends a study before it begins", "[extreme]") {
    OscillatorScene sound("omega = 10"), strict("omega = 1000\nstep = 0.01\non_unstable = \"stop\"");
    set_up(sound.settings, Subject(sound.settings));
    set_up(strict.settings, Subject(strict.settings));  // other methods and steps may do
    OscillatorScene invalid("method = \"explicit\"\nbystander = 200");
    CHECK(kind_of_fault([&] { set_up(invalid.settings, Subject(invalid.settings)); }) == FaultKind::invalid);
}
