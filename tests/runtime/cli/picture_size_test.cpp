#include "cli/picture_size.hpp"

#include <catch2/catch.hpp>

using orbweaver::parse_picture_size;

TEST_CASE("a size of pictures is two numbers and an x, and nothing else", "[unit]") {
    const auto size = parse_picture_size("1280x720");
    REQUIRE(size.has_value());
    CHECK(size->width == 1280);
    CHECK(size->height == 720);
    CHECK(parse_picture_size("16384x1").has_value());
    for (const char* text :
         {"", "x", "1x", "x1", " 12x 3", "12x3 ", "+1x1", "0x1", "-1x1", "16385x1", "1X1", "1x1x1", "0x10x1"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_picture_size(text).has_value());
    }
}
