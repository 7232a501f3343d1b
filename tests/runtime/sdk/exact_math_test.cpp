#include "orbweaver/exact_math.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "orbweaver/random.hpp"

using namespace orbweaver;

namespace {

constexpr long double kPi = 3.14159265358979323846264338327950288L;

// libm in extended precision, reduced in degrees, where that is exact.
long double true_sin(double degrees) {
    return std::sin(std::fmod(static_cast<long double>(degrees), 360) * kPi / 180);
}
long double true_cos(double degrees) {
    return std::cos(std::fmod(static_cast<long double>(degrees), 360) * kPi / 180);
}

}  // namespace

TEST_CASE("sine and cosine of degrees agree with libm within 1e-15", "[unit]") {
    const RandomStream stream(1, "degrees");
    const double reach = GENERATE(1e-6, 1.0, 45.0, 360.0, 1e4, 1e9);
    CAPTURE(reach);
    double worst = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double d = stream.uniform(i, -reach, reach);
        worst = std::max(worst, std::abs(static_cast<double>(sin_degrees(d) - true_sin(d))));
        worst = std::max(worst, std::abs(static_cast<double>(cos_degrees(d) - true_cos(d))));
    }
    CHECK(worst < 1e-15);
}

TEST_CASE("cosine stays exact where an angle and its quarter turn straddle a power of two", "[extreme]") {
    // 2^29 - 0.3 and 90 more have different last places: adding before reducing would lose 1e-9.
    for (double d : {536870911.7, -536870911.7, 536870822.1, 999999999.9, 67108863.99}) {
        CAPTURE(d);
        CHECK(std::abs(static_cast<double>(cos_degrees(d) - true_cos(d))) < 1e-15);
    }
}

TEST_CASE("the angles that people write give the values that they expect", "[unit]") {
    struct Case {
        double degrees, sine, cosine;
    };
    for (const Case& c : {Case{0, 0, 1}, Case{90, 1, 0}, Case{180, 0, -1}, Case{270, -1, 0}, Case{360, 0, 1},
                          Case{-90, -1, 0}, Case{-180, 0, -1}, Case{450, 1, 0}, Case{3.6e8 + 90, 1, 0}}) {
        CAPTURE(c.degrees);
        CHECK(sin_degrees(c.degrees) == c.sine);
        CHECK(cos_degrees(c.degrees) == c.cosine);
    }
    // Between quarter turns the radian is rounded, which costs at most one last place.
    constexpr double kLastPlace = 6e-17;
    CHECK(std::abs(sin_degrees(30) - 0.5) < kLastPlace);
    CHECK(std::abs(cos_degrees(60) - 0.5) < kLastPlace);
    CHECK(sin_degrees(150) == cos_degrees(60));
    CHECK(cos_degrees(240) == -cos_degrees(60));
}

TEST_CASE("sine is odd, cosine even, to the last bit", "[unit]") {
    const RandomStream stream(2, "degrees");
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const double d = stream.uniform(i, 0, 1000);
        CAPTURE(d);
        REQUIRE(sin_degrees(-d) == -sin_degrees(d));
        REQUIRE(cos_degrees(-d) == cos_degrees(d));
    }
}

TEST_CASE("the sine of what is no angle is no number", "[extreme]") {
    const double infinity = std::numeric_limits<double>::infinity();
    for (double d : {infinity, -infinity, std::nan("")}) {
        CHECK(std::isnan(sin_degrees(d)));
        CHECK(std::isnan(cos_degrees(d)));
    }
    CHECK(std::abs(sin_degrees(std::numeric_limits<double>::max())) <= 1);
}

TEST_CASE("the exponential agrees with libm within 1e-14 of its value", "[unit]") {
    const RandomStream stream(3, "exponents");
    const double reach = GENERATE(1e-9, 1.0, 50.0, 700.0);
    CAPTURE(reach);
    double worst = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double x = stream.uniform(i, -reach, reach);
        const long double truth = std::exp(static_cast<long double>(x));
        worst = std::max(worst, std::abs(static_cast<double>((exponential(x) - truth) / truth)));
    }
    CHECK(worst < 1e-14);
}

TEST_CASE("the exponential ends as its limits do", "[extreme]") {
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(exponential(0) == 1);
    CHECK(exponential(-0.0) == 1);
    CHECK(exponential(infinity) == infinity);
    CHECK(exponential(-infinity) == 0);
    CHECK(exponential(1e300) == infinity);
    CHECK(exponential(-1e300) == 0);
    CHECK(std::isnan(exponential(std::nan(""))));
    CHECK(exponential(-740) == Approx(std::exp(-740.0)).epsilon(0.1));  // a denormal keeps few digits
}
