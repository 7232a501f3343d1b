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
    REQUIRE(found.spectrum.size() == 32);
    CHECK(found.spectrum[4] == Approx(1));
}

TEST_CASE("statistics are those of the rows from the first one on", "[unit]") {
    Motion motion = swinging(0.2, 4);
    for (std::size_t i = 0; i < 32; ++i) motion.positions[2 * i] = {100.0 * static_cast<double>(i), 0, 0};
    CHECK(busiest_particle(motion) == 0);
    CHECK(busiest_particle(motion, 32) == 1);
    const Statistics found = measure(motion, 1, 32);  // two of the four cycles
    CHECK(found.mean_energy_j == Approx(47.5));       // of frames 32 to 63, whose energies are their numbers
    CHECK(norm(found.mean_shape[0]) == 0);
    CHECK(found.mean_shape[1].y == Approx(2));
    CHECK(found.power_m2 == Approx(0.02));
    CHECK(found.frequency_hz == Approx(2 / 3.2));
    CHECK(found.spectrum.size() == 16);
}

TEST_CASE("spectra are as far apart as the power that they do not share", "[unit]") {
    const Statistics slow = measure(swinging(0.2, 5), 1);
    const Statistics fast = measure(swinging(0.2, 10), 1);
    CHECK(compare(slow, measure(swinging(0.4, 5), 1)).spectrum == Approx(0).margin(1e-12));
    CHECK(compare(slow, fast).spectrum == Approx(1));
    Motion both = swinging(0.2, 5);  // with as much power at ten cycles
    const Motion other = swinging(0.2, 10);
    for (std::size_t i = 0; i < 64; ++i) both.positions[2 * i + 1].z = other.positions[2 * i + 1].y;
    CHECK(compare(measure(both, 1), slow).spectrum == Approx(0.5));
    CHECK(compare(measure(swinging(0, 1), 1), slow).spectrum == 1);
    CHECK(compare(measure(swinging(0, 1), 1), measure(swinging(0, 2), 1)).spectrum == 0);
}

TEST_CASE("a median is the middle value, or the mean of the middle two", "[unit]") {
    CHECK(median({3}) == 3);
    CHECK(median({1, 3}) == 2);
    CHECK(median({9, 1, 3}) == 3);
    CHECK(median({9, 1, 3, 5}) == 4);
    CHECK(median({}) == 0);
}

TEST_CASE("statistics are compared in what they differ", "[unit]") {
    const Statistics reference = measure(swinging(0.2, 5), 1);
    const Deviation none = compare(reference, reference);
    CHECK(none.energy == 0);
    CHECK(none.shape_m == 0);
    CHECK(none.spectrum == 0);
    CHECK(none.frequency == 0);
    CHECK(none.power == 0);
    const Deviation other = compare(measure(swinging(0.4, 10), 1), reference);
    CHECK(other.frequency == Approx(1));
    CHECK(other.power == Approx(3));
}

TEST_CASE("without energies their mean is not a number", "[unit]") {
    Motion motion = swinging(0.2, 5);
    motion.energy_j.clear();
    const Statistics found = measure(motion, 1);
    CHECK(std::isnan(found.mean_energy_j));
    CHECK(std::isnan(compare(found, found).energy));
}
