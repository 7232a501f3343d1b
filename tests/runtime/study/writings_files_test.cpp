#include "study/writings_files.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "study/svg_plot.hpp"

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

WritingsResult sample() {
    WritingsResult result;
    result.ways.scene = "a <web>";
    result.ways.words = {"inscription",
                         "tasks",
                         "text",
                         "writing",
                         "",
                         "target not met",
                         "writing in it",
                         "lower <left> is better",
                         true};
    result.ways.tasks = {{"as_it_is", "as the scene has it"}};
    result.ways.ways = {{"legible", "as well as can be"}, {"idle", "not at all"}, {"removal", "of silk"}};
    result.ways.rows = {{"as_it_is", "removal", "", 1, 0, 0, 0.5, 0.5, 0.125}};
    result.ways.sentences = {"legible & so on"};
    result.trade = {
        {"legible", "loss 0.2", {0.8, 0.7, 3.5, 0.25, 0.2, 1.25, 1.5e-4, 0.0625, 3, {}}},
        {"legible", "loss 0.1", {0.6, 0.5, 2.5, 0.25, 0.1, 1.125, 1e-4, 0.03125, 2, {}}},
        {"removal", "", {0.4, 0.3, 0.5, 0.125, 0.4, 1.5, 2e-3, 0.5, 17, {}}},
    };
    result.readings = {{"legible", 0, false, "SOME/PIG", 0, 1}, {"removal", 0.5, true, "", 0.75, 0.875}};
    return result;
}

/// How often `text` holds `part`.
std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Everything between the first of `begin` and what follows of `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    REQUIRE(from != std::string::npos);
    return text.substr(from, text.find(end, from) - from);
}

}  // namespace

TEST_CASE("the CSV of the trade has each figure in its column", "[unit]") {
    CHECK(trade_csv(sample()) ==
          "way,setting,iou,ssim,contrast,plain_iou,silk_share,max_tension_ratio,mean_shift_m,spacing_distance,"
          "new_slack\n"
          "legible,loss 0.2,0.8000,0.7000,3.5000,0.2500,0.2000,1.2500,0.00015,0.0625,3\n"
          "legible,loss 0.1,0.6000,0.5000,2.5000,0.2500,0.1000,1.1250,0.0001,0.0312,2\n"
          "removal,,0.4000,0.3000,0.5000,0.1250,0.4000,1.5000,0.002,0.5000,17\n");
}

TEST_CASE("the CSV of readings has a line for each", "[unit]") {
    CHECK(readings_csv(sample()) ==
          "way,time_s,blurred,read,error,plain_error\n"
          "legible,0,false,SOME/PIG,0.0000,1.0000\n"
          "removal,0.5,true,,0.7500,0.8750\n");
    CHECK(readings_csv({}) == "way,time_s,blurred,read,error,plain_error\n");
}

TEST_CASE("the JSON holds the study of ways, the trade and the readings, unrounded", "[unit]") {
    const auto json = nlohmann::json::parse(writings_json(sample()));
    CHECK(json["scene"] == "a <web>");
    CHECK(json["rows"][0]["way"] == "removal");
    REQUIRE(json["trade"].size() == 3);
    CHECK(json["trade"][1] == nlohmann::json{{"way", "legible"},
                                             {"setting", "loss 0.1"},
                                             {"iou", 0.6},
                                             {"ssim", 0.5},
                                             {"contrast", 2.5},
                                             {"plain_iou", 0.25},
                                             {"silk_share", 0.1},
                                             {"max_tension_ratio", 1.125},
                                             {"mean_shift_m", 1e-4},
                                             {"spacing_distance", 0.03125},
                                             {"new_slack", 2}});
    REQUIRE(json["readings"].size() == 2);
    CHECK(json["readings"][1] == nlohmann::json{{"way", "removal"},
                                                {"time_s", 0.5},
                                                {"blurred", true},
                                                {"read", ""},
                                                {"error", 0.75},
                                                {"plain_error", 0.875}});
    const auto none = nlohmann::json::parse(writings_json({}));
    CHECK((none["trade"].is_array() && none["trade"].empty()));
    CHECK((none["readings"].is_array() && none["readings"].empty()));
}

TEST_CASE("the JSON can be read whatever bytes a reader said", "[extreme]") {
    WritingsResult result = sample();
    result.readings[0].read = "P\xffG";
    CHECK(nlohmann::json::parse(writings_json(result))["readings"][0]["read"] == "P\xEF\xBF\xBDG");
}

TEST_CASE("the trade is drawn by the ways' colors: a line by silk, what was there before hollow", "[unit]") {
    // The same by hand.
    const std::vector<double> costs{0, 0.2, 0.1, 0.4}, gains{0, 1};
    SvgPlot plot("legibility against nature",
                 axis_around("silk added and taken / silk of the plain web", costs, false),
                 axis_around("agreement with what was to be written", gains, false));
    const std::vector<PlotPoint> legible{{0.1, 0.6}, {0.2, 0.8}};
    plot.line(legible, color_of(0));
    for (const PlotPoint& each : legible) plot.mark(each, mark_of(0), color_of(0), true, 5);
    plot.mark({0, 0.25}, mark_of(0), color_of(0), false, 5);
    plot.legend_mark("legible", mark_of(0), color_of(0));
    plot.mark({0.4, 0.4}, mark_of(2), color_of(2), true, 5);
    plot.mark({0, 0.125}, mark_of(2), color_of(2), false, 5);
    plot.legend_mark("removal", mark_of(2), color_of(2));
    plot.legend_text("hollow: nothing written");
    CHECK(trade_svg(sample()) == plot.document());
}

TEST_CASE("the page has both plots, the sentences and three tables", "[unit]") {
    WritingsResult result = sample();
    result.readings[1].read = "<P&G>";
    const std::string page = writings_page(result);
    CHECK_THAT(page, Catch::Contains("<title>a &lt;web&gt;: writing in it</title>") &&
                         Catch::Contains("<li>legible &amp; so on</li>") &&
                         Catch::Contains("<p>lower &lt;left&gt; is better</p>"));
    CHECK(count_of(page, "<svg") == 2);
    const std::string read = between(page, "<h2>What is read</h2>", "<h2>By raster and by nature</h2>"),
                      ways = between(page, "<h2>By raster and by nature</h2>", "</body>");
    CHECK(between(page, "<h2>Legibility and nature</h2>\n<table>", "</table>")
              .ends_with(
                  "<tr><td>removal</td><td></td><td>0.4000</td><td>0.3000</td><td>0.5000</td><td>0.1250</td>"
                  "<td>0.4000</td><td>1.5000</td><td>0.002</td><td>0.5000</td><td>17</td></tr>\n"));
    CHECK(
        read ==
        "<h2>What is read</h2>\n<table>\n"
        "<tr><th>way</th><th>time_s</th><th>blurred</th><th>read</th><th>error</th><th>plain_error</th></tr>\n"
        "<tr><td>legible</td><td>0</td><td>false</td><td>SOME/PIG</td><td>0.0000</td><td>1.0000</td></tr>\n"
        "<tr><td>removal</td><td>0.5</td><td>true</td><td>&lt;P&amp;G&gt;</td><td>0.7500</td>"
        "<td>0.8750</td></tr>\n</table>\n");
    CHECK_THAT(ways, Catch::Contains("<tr><td>as_it_is</td><td>removal</td><td></td><td>1</td>"));
}

TEST_CASE("what is read stays one cell, whatever signs it has", "[unit]") {
    WritingsResult result;
    result.readings = {{"legible", 0, true, "A,\"B\"/C", 0.25, 1}, {"removal", 0.5, false, "AB", 1, 1}};
    CHECK(readings_csv(result) ==
          "way,time_s,blurred,read,error,plain_error\n"
          "legible,0,true,\"A,\"\"B\"\"/C\",0.2500,1.0000\n"
          "removal,0.5,false,AB,1.0000,1.0000\n");
    const std::string page = writings_page(result);
    CHECK_THAT(page, Catch::Contains("<td>true</td><td>A,&quot;B&quot;/C</td><td>0.2500</td>"));
    CHECK_THAT(page,
               Catch::Contains("</tr>\n<tr><td>removal</td>") && Catch::Contains("<th>plain_error</th></tr>"));
}
