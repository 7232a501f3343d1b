#include "study/ways_files.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

WaysResult sample() {
    WaysResult result;
    result.scene = "a <rock>";
    result.words = {"queries",
                    "questions",
                    "question",
                    "asking",
                    "m",
                    "largest error / m",
                    "queries of its surface, 12 triangles",
                    "lower <left> is better",
                    false};
    result.facts = {{"triangles", 12U}, {"size_m", 2.5}, {"seed", UINT64_MAX}};
    result.tasks = {{"edges", "rays at edges"}};
    result.ways = {{"wide_tree", "a ray through the wide tree"}, {"guess", "a <guess>"}};
    result.rows = {{"edges", "wide_tree", "", 100, 0, 0, 0, 0, 5e-7},
                   {"edges", "guess", "", 100, 3, 1, 0.25, 0.125, 1e-8}};
    result.sentences = {"edges: guess misses 3"};
    return result;
}

}  // namespace

TEST_CASE("the CSV of queries has its columns", "[unit]") {
    CHECK(ways_csv(sample()) ==
          "questions,way,asked,missed,invented,error_m,median_error_m,cost_s\n"
          "edges,wide_tree,100,0,0,0,0,5e-07\n"
          "edges,guess,100,3,1,0.25,0.125,1e-08\n");
}

TEST_CASE("the JSON of queries says what was asked, how, and what it came to", "[unit]") {
    const auto json = nlohmann::json::parse(ways_json(sample()));
    CHECK(json["scene"] == "a <rock>");
    CHECK(json["triangles"] == 12);
    CHECK(json["size_m"] == 2.5);
    CHECK(json["seed"] == UINT64_MAX);
    CHECK(json["questions"][0]["name"] == "edges");
    CHECK(json["ways"][1]["meaning"] == "a <guess>");
    CHECK(json["rows"][1]["missed"] == 3);
    CHECK(json["rows"][1]["cost_s"] == 1e-8);
    CHECK(json["sentences"][0] == "edges: guess misses 3");
}

TEST_CASE("what misses is drawn hollow, and said in the legend", "[unit]") {
    const std::string svg = ways_svg(sample());
    CHECK_THAT(svg, Catch::Contains("edges: rays at edges") && Catch::Contains("wide_tree, 500 ns<") &&
                        Catch::Contains("guess, 10 ns, misses 4<"));
    CHECK_THAT(svg, Catch::Contains("fill=\"white\" stroke=\"#e69f00\""));
    const std::string page = ways_page(sample());
    CHECK_THAT(page, Catch::Contains("a &lt;rock&gt;: queries of its surface, 12 triangles") &&
                         Catch::Contains("a &lt;guess&gt;") && Catch::Contains("<td>2.50e-01</td>"));
}
