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

TEST_CASE("an axis of labels is ticked at each, or at as many as have room", "[unit]") {
    CHECK(ticks({"x", -0.5, 2.5, false, {"a", "b", "c"}}) == std::vector<double>{0, 1, 2});
    CHECK(ticks({"x", -0.5, 99.5, false, std::vector<std::string>(100, "a")}).size() == 20);
    const SvgPlot plot("t", {"x", -0.5, 1.5, false, {"calm", "a < b"}}, {"y", 0, 1, false}, 492, 286);
    CHECK_THAT(plot.elements(), Catch::Contains(">calm</text>") && Catch::Contains(">a &lt; b</text>"));
}

TEST_CASE("logarithmic axes are marked between their numbers", "[unit]") {
    const auto all = minor_ticks({"x", 1, 100, true});
    REQUIRE(all.size() == 19);
    CHECK(all[1] == Approx(2));
    CHECK(all[10] == Approx(20));
    CHECK(minor_ticks({"x", 1, 100, false}).empty());
    CHECK(minor_ticks({"x", 1e-300, 1e300, true}).empty());
}

TEST_CASE("zero has no sign", "[unit]") {
    const SvgPlot plot("t", {"x", 0, 1, false}, {"y", 0, 1, false});
    CHECK_THAT(plot.elements(), !Catch::Contains(">-0<"));
}

TEST_CASE("a plot grows by what its labels and legend need", "[unit]") {
    const Axis usual{"x", 0, 1, false};
    const std::string name(40, 'a');
    SvgPlot plot("t", usual, usual, 492, 286);
    CHECK(plot.width() == 492);
    CHECK(plot.height() == 286);
    plot.legend_text(name);
    CHECK(plot.width() > 492);
    for (int i = 0; i < 20; ++i) plot.legend_text("b");
    CHECK(plot.height() > 400);
    const Axis labels{"y", -0.5, 1.5, false, {name, "b"}};
    CHECK(SvgPlot("t", usual, labels, 492, 286).width() > 600);
    const SvgPlot sloping("t", labels, usual, 492, 286);
    CHECK(sloping.height() > 400);
    CHECK_THAT(sloping.elements(), Catch::Contains("rotate(-35"));
}

TEST_CASE("a line is cut off where it leaves the plot", "[unit]") {
    SvgPlot plot("t", {"x", 1, 100, true}, {"y", 0, 10, false}, 492, 286);  // 200 by 200 inside
    const PlotPoint out[] = {{10, 5}, {100, 15}};
    plot.line(out, "#123456");
    CHECK_THAT(plot.elements(), Catch::Contains("<line x1=\"172.0\" y1=\"134.0\" x2=\"222.0\" y2=\"34.0\""));
    const std::size_t before = plot.elements().size();
    const PlotPoint beyond[] = {{200, 1}, {300, 9}};
    plot.line(beyond, "#123456");
    CHECK(plot.elements().size() == before);
    const PlotPoint across[] = {{0, 5}, {HUGE_VAL, 5}};
    plot.line(across, "#654321");
    CHECK_THAT(plot.elements(), Catch::Contains("<line x1=\"72.0\" y1=\"134.0\" x2=\"272.0\" y2=\"134.0\""));
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
