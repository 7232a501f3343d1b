#include "error_growth.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace orbweaver::mass_spring;

TEST_CASE("what nothing damps grows with the frames, what drag damps with its lifetime", "[unit]") {
    const std::vector<double> together(50, 1.0);
    const ErrorGrowth endless(together, 1);
    CHECK(endless.from(10, 1000) == Approx(100));
    CHECK(endless.damped_from(10, 1000) == Approx(100));
    // sum of 0.99^j: 100 (1 - 0.99^n)
    const ErrorGrowth damped({}, 0.99);
    CHECK(damped.from(10, 1e9) == Approx(1 / (1 - std::pow(0.99, 10))));
    CHECK(damped.from(10, 200) == Approx((1 - std::pow(0.99, 200)) / (1 - std::pow(0.99, 10))));
    CHECK_FALSE(endless.is_chaotic(1e5));
}

TEST_CASE("twins that come together sooner than drag has it do not shorten what is off", "[unit]") {
    const std::vector<double> brief{0.5, 0.1, 0.01, 0.001};
    CHECK(ErrorGrowth(brief, 0.9).from(2, 100) == Approx(ErrorGrowth({}, 0.9).from(2, 100)));
}

TEST_CASE("twins that part multiply errors, beyond what was seen too", "[unit]") {
    std::vector<double> parted;
    for (int j = 0; j < 40; ++j) parted.push_back(std::pow(1.2, j));
    const ErrorGrowth growth(parted, 1);
    // sum of 1.2^j
    CHECK(growth.from(10, 40) == Approx((std::pow(1.2, 40) - 1) / (std::pow(1.2, 10) - 1)));
    const double exact = std::pow(1.2, 200 - 10);
    CHECK(growth.from(10, 200) > exact / 10);
    CHECK(growth.from(10, 200) < exact * 10);
    CHECK(growth.damped_from(10, 200) == Approx(20));
    CHECK_FALSE(growth.is_chaotic(40));
    CHECK(growth.is_chaotic(200));
    CHECK(std::isfinite(growth.from(10, 1e12)));
}

TEST_CASE("a run is never better than what was tried of it", "[unit]") {
    CHECK(ErrorGrowth(std::vector<double>{1, 1}, 0.1).from(10, 10) == 1);
    CHECK(ErrorGrowth({}, 1).from(10, 5) == 1);
}
