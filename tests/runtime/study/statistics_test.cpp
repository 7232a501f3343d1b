#include "study/statistics.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

/// A particle at rest and one that swings by `amplitude` about (1, 2, 3), `cycles` times in 64 rows of 0.1 s.
Motion swinging(double amplitude, int cycles) {
    Motion motion{2, 0.1, {}, {}};
    for (int i = 0; i < 64; ++i) {
        const double angle = 2 * std::numbers::pi * cycles * i / 64;
        motion.positions.push_back({0, 0, 0});
        motion.positions.push_back({1, 2 + amplitude * std::sin(angle), 3});
        if (i > 0) motion.energy_j.push_back(i);
    }
    return motion;
}

}  // namespace

TEST_CASE("a swing has its mean, its frequency and half its squared amplitude as power", "[unit]") {
    const Motion motion = swinging(0.2, 5);
    REQUIRE(busiest_particle(motion) == 1);
    const Statistics found = measure(motion, 1);
    CHECK(found.mean_energy_j == Approx(32));
    CHECK(found.mean_shape[1].y == Approx(2));
    CHECK(found.frequency_hz == Approx(5 / 6.4));
    CHECK(found.power_m2 == Approx(0.02));
}

TEST_CASE("statistics are compared in what they differ", "[unit]") {
    const Statistics reference = measure(swinging(0.2, 5), 1);
    const Deviation none = compare(reference, reference);
    CHECK(none.energy == 0);
    CHECK(none.shape_m == 0);
    CHECK(none.frequency == 0);
    CHECK(none.power == 0);
    const Deviation other = compare(measure(swinging(0.4, 10), 1), reference);
    CHECK(other.frequency == Approx(1));
    CHECK(other.power == Approx(3));
}

TEST_CASE("without energies their mean is not a number", "[unit]") {
    Motion motion = swinging(0.2, 5);
    motion.energy_j.clear();
    CHECK(std::isnan(measure(motion, 1).mean_energy_j));
}
