#pragma once

#include "crawling.hpp"

/// Bodies that several tests have crawl.
namespace crawling {

inline constexpr double kG = 9.81;  ///< m/s^2
/// Of widths: within which Crawl has points on the ground.
inline constexpr double kNear = 1e-4;

/// A worm of 10 cm, one wave long and of 20 segments, that crawls slowly.
inline Setup worm(double strain, double forward, double backward) {
    Setup setup;
    setup.build.segments = 20;
    setup.build.length = 0.1;
    setup.build.width = 0.005;
    setup.build.keeps_volume = false;
    setup.make_springs(5, 1.6, 2e-3);
    setup.waves = 1;
    setup.period = 1;
    setup.effort.strain = strain;
    setup.friction = {FrictionLaw::coulomb, forward, backward, 0.02};
    return setup;
}

/// A limp bar of ten segments, which a floor meets gently.
inline Setup bar() {
    Setup setup;
    setup.build.segments = 10;
    setup.build.length = 0.05;
    setup.build.width = 0.01;
    setup.make_springs(3, 1.5, 2e-3);
    return setup;
}

/// A bar on a slope: gravity leans by `along` and `across` (m/s^2) to the floor.
inline Setup on_slope(double along, double across, const Friction& friction, const char* method) {
    Setup setup = bar();
    setup.gravity = {along, -kG, across};
    setup.friction = friction;
    setup.method = method;
    // A quarter of the time that the springs' stiffness stands for. At half of it, and as little damped, points
    // jump on the ground and the bar creeps where it should lie.
    if (setup.method == std::string_view("implicit_euler")) setup.step = 5e-4;
    return setup;
}

}  // namespace crawling
