#include "step_control.hpp"

#include <catch2/catch.hpp>
#include <limits>

using orbweaver::mass_spring::StepControl;

TEST_CASE("a step is scaled to leave the next one half the tolerance", "[unit]") {
    const StepControl control(1, 1e-6);  // errors shrink with the square of the step
    CHECK(control.scale(0.5e-6) == 1);
    CHECK(control.scale(0.3e-6) == 1.2);      // 0.3 * 1.44 < 0.5
    CHECK(control.scale(0.5e-6 / 4.1) == 2);  // doubling makes four of it
    CHECK(control.scale(1e-6) == 0.7);        // accepted, and shortened all the same
    CHECK(control.scale(0.5e-6 / (0.35 * 0.35)) == 0.35);
    CHECK(control.scale(0) == 5);
    CHECK(control.scale(1e30) == 0.2);
}

TEST_CASE("an error that means nothing is no step's", "[unit]") {
    const StepControl control(4, 1e-6);
    for (const double error :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK_FALSE(control.accepts(error));
        CHECK(control.scale(error) == 0.2);
    }
    CHECK(control.accepts(1e-6));
    CHECK_FALSE(control.accepts(1.0001e-6));
}
