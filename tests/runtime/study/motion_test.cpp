#include "study/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

/// Two particles, three rows, 0.5 s apart: the first rests, the second goes `reach` along x in each.
Motion moving(double reach) {
    return {2, 0.5, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1 + reach, 0, 0}, {0, 0, 0}, {1 + 2 * reach, 0, 0}}, {}};
}

}  // namespace

TEST_CASE("motions are compared by the particle that is farthest off, row by row", "[unit]") {
    const Motion a = moving(1);
    const Motion b = moving(1.5);
    CHECK(a.rows() == 3);
    CHECK(distances(a, b) == std::vector<double>{0, 0.5, 1});
    CHECK(distance(a, b, 2) == 0.5);
    CHECK(distance(a, b, 99) == 1);
    CHECK(distance(a, b, 0) == 0);
}

TEST_CASE("a place that is not a number is infinitely far", "[extreme]") {
    Motion bad = moving(1);
    bad.positions[3].y = std::nan("");
    CHECK(std::isinf(distance(moving(1), bad, 3)));
}

TEST_CASE("displacement and speed are those of the definition", "[unit]") {
    const Motion motion = moving(3);
    CHECK(largest_displacement(motion) == 6);
    // One of two particles at 3 m in 0.5 s: sqrt(36/2) m/s.
    CHECK(rms_speed(motion) == Approx(std::sqrt(18.0)));
    CHECK(rms_speed(Motion{2, 0.5, {{0, 0, 0}, {1, 0, 0}}, {}}) == 0);
}
