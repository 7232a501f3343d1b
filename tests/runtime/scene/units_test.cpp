#include "scene/units.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;

namespace {

struct Case {
    const char* text;
    const char* unit;
    double value;
};

}  // namespace

TEST_CASE("a quantity in words becomes the exact number of the unit asked for", "[unit]") {
    const Case cases[] = {
        {"7 mm", "m", 0.007},
        {"7mm", "m", 0.007},
        {"  7 \t mm ", "m", 0.007},
        {"10 ug", "kg", 1e-8},
        {"10 \xC2\xB5g", "kg", 1e-8},
        {"10 \xCE\xBCg", "kg", 1e-8},
        {"3 nm", "m", 3e-9},
        {"2.5 cm", "m", 0.025},
        {"1.2 km", "m", 1200},
        {"4 MPa", "Pa", 4e6},
        {"4 GPa", "N/m^2", 4e9},
        {"1/60 s", "s", 1.0 / 60},
        {"1 / 60 s", "s", 1.0 / 60},
        {"-3/4 m", "m", -0.75},
        {"+3 m", "m", 3},
        {"2 min", "s", 120},
        {"1.5 h", "s", 5400},
        {"50 Hz", "1/s", 50},
        {"50 deg", "deg", 50},
        {"180 deg", "rad", 3.14159265358979323846},
        {"1e-8 N s/m", "N s/m", 1e-8},
        {"1e-8 kg/s", "N s/m", 1e-8},
        {"3 mN/mm", "N/m", 3},
        {"1 g/cm3", "kg/m^3", 1000},
        {"1 g/cm^3", "kg/m3", 1000},
        {"9.81 m s^-2", "m/s^2", 9.81},
        {"9.81 m s-2", "m/s/s", 9.81},
        {"9.81 m*s-2", "m/s^2", 9.81},
        {"2 kJ", "N m", 2000},
        {"3 W", "J/s", 3},
        {"640 px", "px", 640},
        {"12 1", "1", 12},
        {"36 km/h", "m/s", 10},
    };
    for (const Case& c : cases) {
        CAPTURE(c.text, c.unit);
        const auto quantity = parse_quantity(c.text);
        const auto unit = parse_unit(c.unit);
        REQUIRE(quantity);
        REQUIRE(unit);
        CHECK(quantity->has_unit);
        REQUIRE(quantity->unit.same_dimension(*unit));
        CHECK(convert(*quantity, *unit) == Approx(c.value).epsilon(1e-15));
    }
}

TEST_CASE("decimal prefixes round as the number written out would", "[unit]") {
    for (const Case& c : {Case{"7 mm", "m", 0.007}, Case{"0.1 mm", "m", 0.0001}, Case{"10 ug", "kg", 1e-8},
                          Case{"0.3 cm", "m", 0.003}, Case{"17 nm", "m", 17e-9}, Case{"8 ug", "kg", 8e-9}}) {
        CAPTURE(c.text);
        CHECK(convert(*parse_quantity(c.text), *parse_unit(c.unit)) == c.value);
    }
}

TEST_CASE("a number alone has no unit", "[unit]") {
    for (const char* text : {"12", "-1e-3", "1/60", " 5 "}) {
        CAPTURE(text);
        REQUIRE(parse_quantity(text));
        CHECK_FALSE(parse_quantity(text)->has_unit);
    }
    CHECK(parse_quantity("1/60")->value == 1.0 / 60);
}

TEST_CASE("what is no quantity is refused", "[extreme]") {
    for (const char* text : {"",        " ",        "m",     "mm 7",     "7 parsec",   "7 mmm",   "7 kmin",
                             "7 kdeg",  "7 mh",     "7 m/",  "7 /",      "7 / m",      "1/",      "--7 m",
                             "+-7 m",   "7 m^",     "7 m^x", "7 m-",     "7 m99",      "7 m^-99", "0x10 m",
                             "1e999 m", "7 m // s", "7, m",  "7 \xC2 m", "7 \xC2\xB5", "1 2",     "7 m\n"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_quantity(text));
    }
    CHECK_FALSE(parse_quantity("1 " + std::string(100000, 'm')));
    CHECK_FALSE(parse_unit(""));
    CHECK_FALSE(parse_unit(std::string(100000, ' ')));
}

TEST_CASE("units of other dimensions are told apart", "[unit]") {
    const char* units[] = {"m",     "kg", "s", "rad", "px", "1",   "N",  "N/m",
                           "N s/m", "J",  "W", "Pa",  "Hz", "m^2", "m/s"};
    for (const char* a : units)
        for (const char* b : units) {
            CAPTURE(a, b);
            CHECK(parse_unit(a)->same_dimension(*parse_unit(b)) == (std::string(a) == b));
        }
}

TEST_CASE("a chain of units too large for a number is not finite rather than wrong", "[extreme]") {
    const auto huge = parse_unit("Gm9 Gm9 Gm9 Gm9 Gm9 Gm9 Gm9 Gm9");
    REQUIRE(huge);
    CHECK_FALSE(std::isfinite(convert({1, *huge, true}, *parse_unit("m9 m9 m9 m9 m9 m9 m9 m9"))));
}
