#include "picture/color.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver::picture;

TEST_CASE("sRGB shades have the light that IEC 61966-2-1 gives them", "[unit]") {
    CHECK(linear_from_srgb(0) == 0);
    CHECK(linear_from_srgb(1) == Approx(1));
    CHECK(linear_from_srgb(0.5F) == Approx(0.21404).epsilon(1e-4));  // ((0.5 + 0.055) / 1.055)^2.4
    CHECK(linear_from_srgb(0.04F) == Approx(0.04 / 12.92));
}

TEST_CASE("every byte comes back from its light", "[unit]") {
    const auto light = linear_from_byte();
    for (int i = 0; i < 256; ++i) CHECK(byte_from_linear(light[static_cast<std::size_t>(i)]) == i);
}

TEST_CASE("light beyond the scale is clamped", "[unit]") {
    CHECK(byte_from_linear(-1) == 0);
    CHECK(byte_from_linear(1e6F) == 255);
}
