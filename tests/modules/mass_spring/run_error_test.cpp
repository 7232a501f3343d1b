#include "run_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kFrame = 1.0 / 60;

/// A taut string whose links are damped, in a steady wind across it that is put on at the start, with drag.
struct Run {
    std::vector<Vec3> x;
    double estimate = 0;  ///< m
    std::string how;
};

Run blow(const char* method, double step, double tolerance, int frames, std::uint64_t first = 0) {
    Body body = bodies::bead_string(9, 0.01, 1e-6, 500, 0.01);
    for (Spring& s : body.network.springs) s.damping = 1e-4;
    const std::vector<Vec3> wind(body.x.size(), Vec3{0, 2e-4, 0});
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 1e-4, wind});
    SimulationSettings settings;
    settings.method = find_method(method);
    settings.step = step;
    settings.tolerance = tolerance;
    Simulation run(system, settings, kFrame, body.x, body.v);
    for (int i = 0; i < frames; ++i) run.advance(first + static_cast<std::uint64_t>(i), i * kFrame);
    return {body.x, run.error_estimate(), run.error_method()};
}

double error_of(const Run& run, const Run& exact) {
    double largest = 0;
    for (std::size_t i = 0; i < run.x.size(); ++i) largest = std::max(largest, distance(run.x[i], exact.x[i]));
    return largest;
}

}  // namespace

TEST_CASE("what a run is off by while it moves is told within a few times", "[unit]") {
    struct Case {
        const char* method;
        double step, tolerance;
    };
    const Run exact = blow("tr_bdf2", 2e-5, 0, 2);
    for (const Case& each : {Case{"implicit_euler", 1e-3, 0}, {"tr_bdf2", 1e-3, 0}, {"tr_bdf2", 0, 1e-6}}) {
        INFO(each.method << ", " << each.step << " s, within " << each.tolerance << " m");
        const Run run = blow(each.method, each.step, each.tolerance, 2);
        const double error = error_of(run, exact);
        INFO("off by " << error << " m, told " << run.estimate << " m: " << run.how);
        CHECK(run.estimate > error / 2);
        CHECK(run.estimate < 10 * error);
    }
}

TEST_CASE("errors that the motion's own damping takes do not add up over a long run", "[unit]") {
    // At rest in the wind after a second: what the first frames erred by is long forgotten.
    const double soon = blow("implicit_euler", 1e-3, 0, 60).estimate;
    const double late = blow("implicit_euler", 1e-3, 0, 600).estimate;
    CHECK(late < 1.1 * soon);
}

TEST_CASE("what happens between two samples is not passed over", "[unit]") {
    // A bead falls past its anchor at a millimetre's distance, in frame 27: the thread turns about within one
    // frame.
    const auto fall = [](const char* method, double step, double tolerance, double frame_step) {
        Body body;
        body.add({0, 0, 0}, 1e-6, true);
        body.add({0.001, 1, 0}, 1e-6);
        body.join(0, 1, 0.2, 1e-5);
        SpringSystem system(body.network, nullptr);
        system.set_surroundings({{0, -9.81, 0}, 0, {}});
        SimulationSettings settings;
        settings.method = find_method(method);
        settings.step = step;
        settings.tolerance = tolerance;
        Simulation run(system, settings, frame_step, body.x, body.v);
        const int frames = static_cast<int>(std::lround(2 / frame_step));
        for (int i = 0; i < frames; ++i) run.advance(static_cast<std::uint64_t>(i), i * frame_step);
        return Run{body.x, run.error_estimate(), run.error_method()};
    };
    const Run exact = fall("rk4", 1e-6, 0, kFrame);
    struct Case {
        const char* method;
        double step, tolerance;
    };
    for (const Case& each : {Case{"rk4", kFrame, 0},
                             {"tsit5", kFrame, 0},
                             {"tsit5", 0, 1e-4},
                             {"tsit5", 0, 1e-6},
                             {"srkn6", kFrame, 0},
                             {"tr_bdf2", kFrame, 0},
                             {"verlet", 1e-3, 0}}) {
        const Run run = fall(each.method, each.step, each.tolerance, kFrame);
        const double error = error_of(run, exact);
        INFO(each.method << " in " << each.step << " s, within " << each.tolerance << " m: off by " << error
                         << ", told " << run.estimate << " m: " << run.how);
        CHECK(run.estimate > error / 3);
    }
}

TEST_CASE("a run that goes on from another says that it tells its own part alone", "[unit]") {
    CHECK(blow("rk4", 1e-4, 0, 3).how.find("nothing is told") == std::string::npos);
    CHECK(blow("rk4", 1e-4, 0, 3, 20).how.find("; of what came before frame 20 nothing is told") !=
          std::string::npos);
}
