#include "study/svg_plot.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver::study;

TEST_CASE("logarithmic axes are ticked at powers of ten, short ones at 2 and 5 too", "[unit]") {
    const auto far = ticks({"x", 1e-6, 1e-1, true});
    REQUIRE(far.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) CHECK(far[i] == Approx(std::pow(10, static_cast<double>(i) - 6)));
    const auto near = ticks({"x", 0.15, 12, true});
    REQUIRE(near.size() == 6);
    CHECK(near[0] == Approx(0.2));
    CHECK(near[1] == Approx(0.5));
    CHECK(near[5] == Approx(10));
    CHECK(ticks({"x", 1e-300, 1e300, true}).size() < 20);
}

TEST_CASE("linear axes are ticked at round numbers", "[unit]") {
    CHECK(ticks({"x", 0, 1, false}).size() == 6);
    CHECK(ticks({"x", 0, 1, false})[1] == Approx(0.2));
    const auto shifted = ticks({"x", -3, 17, false});
    CHECK(shifted.front() == Approx(0).margin(1e-12));
    CHECK(shifted.back() == Approx(15));
}

TEST_CASE("an axis holds all values that can be shown and is never empty", "[unit]") {
    const double values[] = {3e-4, 0.2, 0, -1, HUGE_VAL, std::nan("")};
    const Axis log = axis_around("x", values, true);
    CHECK(log.low == Approx(1e-4));
    CHECK(log.high == Approx(1));
    CHECK(axis_around("x", {}, true).low < axis_around("x", {}, true).high);
    const double one[] = {5};
    CHECK(axis_around("x", one, false).high > 5);
    CHECK(axis_around("x", one, true).high > axis_around("x", one, true).low);
}

TEST_CASE("values lie where the axes put them", "[unit]") {
    SvgPlot plot("t", {"x", 1, 100, true}, {"y", 0, 10, false}, 492, 286);  // 200 by 200 inside
    plot.mark({10, 5}, Mark::circle, "#123456");
    CHECK_THAT(plot.elements(), Catch::Contains("<circle cx=\"172.0\" cy=\"134.0\""));
    plot.cell({1, 0}, {10, 5}, "#abcdef");
    CHECK_THAT(
        plot.elements(),
        Catch::Contains("<rect x=\"72.00\" y=\"134.00\" width=\"100.00\" height=\"100.00\" fill=\"#abcdef\""));
}

TEST_CASE("what is no number is left out, what is too far is drawn at the end", "[extreme]") {
    SvgPlot plot("t", {"x", 1, 100, true}, {"y", 0, 10, false}, 492, 286);
    const std::size_t before = plot.elements().size();
    plot.mark({std::nan(""), 5}, Mark::square, "#123456");
    plot.mark({-1, 5}, Mark::square, "#123456");
    const PlotPoint line[] = {{1, 1}, {2, std::nan("")}, {3, 3}};
    plot.line(line, "#123456");
    CHECK(plot.elements().size() == before);
    plot.mark({HUGE_VAL, -HUGE_VAL}, Mark::circle, "#123456");
    CHECK_THAT(plot.elements(), Catch::Contains("<circle cx=\"272.0\" cy=\"234.0\""));
    CHECK_THAT(plot.elements(), !Catch::Contains("nan"));
}

TEST_CASE("text is escaped, documents are whole, grids hold every plot", "[unit]") {
    CHECK(escaped("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
    const SvgPlot plot("<t>", {"x", 0, 1, false}, {"y", 0, 1, false}, 300, 200);
    CHECK_THAT(plot.document(), Catch::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"300\""));
    CHECK_THAT(plot.document(), Catch::EndsWith("</svg>\n"));
    const SvgPlot plots[] = {plot, plot, plot};
    const std::string grid = svg_grid(plots, 2);
    CHECK_THAT(grid, Catch::Contains("width=\"600\" height=\"400\""));
    CHECK_THAT(grid, Catch::Contains("translate(0 200)"));
}

TEST_CASE("things are told apart by color and mark together", "[unit]") {
    for (std::size_t i = 0; i < 14; ++i)
        for (std::size_t j = 0; j < i; ++j) CHECK((color_of(i) != color_of(j) || mark_of(i) != mark_of(j)));
}
