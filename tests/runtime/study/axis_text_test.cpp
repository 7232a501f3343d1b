#include "study/axis_text.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver::study;

namespace {

AxisRange range_of(const std::string& text) {
    const auto axis = parse_axis(text);
    REQUIRE(axis);
    return std::get<AxisRange>(axis->values);
}

AxisList list_of(const std::string& text) {
    const auto axis = parse_axis(text);
    REQUIRE(axis);
    return std::get<AxisList>(axis->values);
}

std::string numbered_list(int count) {
    std::string text = "web.step=1";
    for (int i = 2; i <= count; ++i) text += "," + std::to_string(i);
    return text;
}

}  // namespace

TEST_CASE("a range is a path, two ends and a count", "[unit]") {
    CHECK(parse_axis("web.strand.stiffness=1e-5..0.1:16:lin")->path == "web.strand.stiffness");
    const AxisRange range = range_of("web.strand.stiffness=1e-5..0.1:16:lin");
    CHECK(range.low.value == 1e-5);
    CHECK(range.high.value == 0.1);
    CHECK(range.count == 16);
    CHECK(range.log == false);
    CHECK(range_of("a.b=1..2:3").log == std::nullopt);
    CHECK(range_of("a.b=1..2:3:log").log == true);
    CHECK(range_of("a.b=-2..-1:3").low.value == -2);
}

TEST_CASE("a list is a path and values between commas, those within brackets and quotes whole", "[unit]") {
    CHECK(parse_axis("web.method=rk4, verlet")->path == "web.method");
    CHECK(list_of("web.method=rk4, verlet") == AxisList{"rk4", "verlet"});
    CHECK(list_of("web.step=1 ms,2 ms,5 ms") == AxisList{"1 ms", "2 ms", "5 ms"});
    CHECK(list_of("scene.gravity=[0, -9.81, 0],[0,0,0]") == AxisList{"[0, -9.81, 0]", "[0,0,0]"});
    CHECK(list_of("web.species=\"a,b\",'c,d'") == AxisList{"\"a,b\"", "'c,d'"});
    CHECK(list_of("web.outer_frame={ move = 1, n = 2 },{}") == AxisList{"{ move = 1, n = 2 }", "{}"});
    CHECK(list_of(numbered_list(200)).size() == 200);
}

TEST_CASE("what is no axis is none", "[extreme]") {
    for (const char* text : {"",
                             "web.step",
                             "web.step=1",
                             "web.step=1..2",
                             "step=1..2:3",
                             "web.step=2..1:3",
                             "web.step=1..1:3",
                             "web.step=1..2:1",
                             "web.step=1..2:0",
                             "web.step=1..2:201",
                             "web.step=1..2:-3",
                             "web.step=1..2:3:cubic",
                             "web.step=0..2:3:log",
                             "web.step=-1..2:3:log",
                             "web.step=a..b:3",
                             "web.step=1..1e999:3",
                             "web.step=nan..2:3",
                             "web.step=1e-300..1e300:3",
                             ".step=1..2:3",
                             "web.=1,2",
                             "web..step=1,2",
                             "=1,2",
                             "web.step=1..nan:3",
                             "web.step=1..inf:3",
                             "web.step=1 parsec..2 parsec:3",
                             "web.step=1..2:3:lin:lin",
                             "web.step=1..2:99999999999",
                             "web.step=",
                             "web.step=,",
                             "web.step=1,",
                             "web.step=,1",
                             "web.step=1,,2",
                             "web.step=1, ,2",
                             "step=1,2",
                             "web.method=rk4",
                             "web.step=[1,2]"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_axis(text));
    }
    CHECK_FALSE(parse_axis(numbered_list(201)));
}
