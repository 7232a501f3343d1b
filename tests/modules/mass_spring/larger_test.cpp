#include "larger.hpp"

#include <catch2/catch.hpp>

using orbweaver::mass_spring::larger;

TEST_CASE("the larger of two by size, and a NaN before all", "[unit]") {
    CHECK(larger(1, -2) == 2);
    CHECK(larger(3, -2) == 3);
    CHECK(std::isnan(larger(1, std::nan(""))));
    CHECK(std::isnan(larger(std::nan(""), 1)));
    CHECK(std::isinf(larger(1, -HUGE_VAL)));
}
