#include "target_options.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"
#include "target_file.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

Options options(const std::vector<std::pair<std::string, OptionValue>>& values) {
    Options all;
    for (const auto& [key, value] : values) all.set(key, value, {});
    return all;
}

}  // namespace

TEST_CASE("what a scene leaves out is as the recipe has it", "[unit]") {
    TargetRecipe plain;
    plain.text = "A";
    CHECK(recipe_text(target_recipe(options({{"text", "A"}}))) == recipe_text(plain));
}

TEST_CASE("every option reaches the recipe", "[unit]") {
    const TargetRecipe picture = target_recipe(options({{"target", "a.png"},
                                                        {"threshold", 0.25},
                                                        {"invert", true},
                                                        {"low_pass", 2.0},
                                                        {"margin", 0.1},
                                                        {"gaps", 0.2},
                                                        {"gaps_seed", std::int64_t{9}},
                                                        {"resolution", std::int64_t{300}}}));
    CHECK(
        recipe_text(picture) ==
        "source: picture\nsize: 300 x 300\nmargin: 0.1\nthreshold: 0.25\ninvert: yes\nlow_pass: 2\ngaps: 0.2\n"
        "seed: 9\n");
    CHECK(picture.picture == "a.png");
    const TargetRecipe text = target_recipe(options({{"text", "A\nB"},
                                                     {"font", "DejaVu Sans Mono"},
                                                     {"weight", "regular"},
                                                     {"align", "right"},
                                                     {"line_spacing", 1.5}}));
    CHECK(
        recipe_text(text) ==
        "source: text\nsize: 600 x 600\nmargin: 0.05\ntext: A\\nB\nfont: DejaVuSansMono.ttf\nweight: regular\n"
        "align: right\nline_spacing: 1.5\n");
    CHECK(target_recipe(options({{"text", "A"}, {"align", "left"}})).align == Align::left);
}

TEST_CASE("each word is a line of its own, whatever parts it from others, unless lines are kept", "[unit]") {
    for (const char* text :
         {"SOME PIG", "SOME  PIG", " SOME PIG", "SOME PIG ", "SOME\n\nPIG\n", " \n SOME \n PIG"}) {
        CAPTURE(text);
        CHECK(target_recipe(options({{"text", text}, {"lines", "words"}})).text == "SOME\nPIG");
        CHECK(target_recipe(options({{"text", text}, {"lines", "as_written"}})).text == text);
    }
    CHECK(target_recipe(options({{"text", " \n "}, {"lines", "words"}})).text == "");
}

namespace {

/// Options as a scene gives them, each in a line of its own number.
Options given(const std::vector<std::pair<std::string, OptionValue>>& values) {
    Options all;
    int line = 0;
    for (const auto& [key, value] : values) all.set(key, value, {"scene.toml", ++line, 1});
    return all;
}

}  // namespace

TEST_CASE("an option that makes no difference is told with its place", "[unit]") {
    const test::Scratch folder;
    const std::string baked = folder.path("t.baked");
    write_target(baked, test::random_bitmap(32, 32, 0.2, 1), {1, 2}, "source: text\ntext: A\n");
    const std::pair<std::string, OptionValue> picture{"target", "a.png"}, ready{"target", baked},
        text{"text", "A"}, gaps{"gaps", 0.1};
    struct Case {
        std::vector<std::pair<std::string, OptionValue>> options;
        const char* sentence;
    };
    for (const auto& [options, sentence] : std::vector<Case>{
             {{text, {"threshold", 0.5}}, "'threshold' has no effect on words; expected it beside a picture"},
             {{text, {"invert", true}}, "'invert' has no effect on words; expected it beside a picture"},
             {{text, {"low_pass", 2.0}}, "'low_pass' has no effect on words; expected it beside a picture"},
             {{gaps, {"low_pass", 2.0}},
              "'low_pass' has no effect on gaps alone; expected it beside a picture"},
             {{picture, {"font", "DejaVu Sans"}},
              "'font' has no effect on a picture; expected it beside 'text'"},
             {{picture, {"weight", "bold"}}, "'weight' has no effect on a picture; expected it beside 'text'"},
             {{picture, {"align", "left"}}, "'align' has no effect on a picture; expected it beside 'text'"},
             {{picture, {"line_spacing", 1.0}},
              "'line_spacing' has no effect on a picture; expected it beside 'text'"},
             {{ready, {"lines", "words"}},
              "'lines' has no effect on a target that is baked; expected it beside 'text'"},
             {{gaps, {"margin", 0.1}},
              "'margin' has no effect on gaps alone; expected it beside a picture or 'text'"},
             {{ready, {"margin", 0.1}},
              "'margin' has no effect on a target that is baked; expected it beside a picture or 'text'"},
             {{ready, {"threshold", 0.1}},
              "'threshold' has no effect on a target that is baked; expected it beside a picture"},
             {{ready, gaps},
              "'gaps' has no effect on a target that is baked; expected it beside a picture or 'text', or "
              "alone"},
             {{text, {"gaps_seed", std::int64_t{2}}},
              "'gaps_seed' has no effect on words; expected it beside 'gaps'"},
             {{{"mode", "random_gaps"}, text},
              "mode 'random_gaps' writes no 'text'; expected 'gaps' alone, or a baked target"},
             {{{"mode", "random_gaps"}, picture},
              "mode 'random_gaps' writes no 'target'; expected 'gaps' alone, or a baked target"},
             {{{"mode", "legible"}, gaps}, "mode 'legible' writes no gaps; expected words or a picture"}}) {
        CAPTURE(sentence);
        const Diagnostics faults = idle_options(given(options));
        REQUIRE(faults.size() == 1);
        CHECK(to_string(faults[0]).starts_with("scene.toml:2:1: " + std::string(sentence) + "; "));
    }
}

TEST_CASE("options that make a difference, and defaults, are no fault", "[unit]") {
    const test::Scratch folder;
    const std::string baked = folder.path("t.baked");
    write_target(baked, test::random_bitmap(32, 32, 0.2, 1), {1, 2}, "source: gaps\n");
    for (const auto& values : std::vector<std::vector<std::pair<std::string, OptionValue>>>{
             {{"target", "a.png"}, {"threshold", 0.5}, {"invert", true}, {"low_pass", 1.0}, {"margin", 0.1}},
             {{"text", "A"},
              {"font", "a"},
              {"weight", "bold"},
              {"align", "left"},
              {"line_spacing", 1.0},
              {"lines", "words"},
              {"margin", 0.1}},
             {{"mode", "removal"}, {"text", "A"}, {"gaps", 0.1}, {"gaps_seed", std::int64_t{2}}},
             {{"mode", "random_gaps"}, {"gaps", 0.1}, {"gaps_seed", std::int64_t{2}}},
             {{"mode", "random_gaps"}, {"target", baked}, {"resolution", std::int64_t{300}}},
             {{"mode", "legible"}, {"text", "A"}, {"gaps", 0.0}}}) {
        CHECK(idle_options(given(values)).empty());
    }
    Options defaults = given({{"target", "a.png"}});
    defaults.set("font", "DejaVu Sans", {});
    defaults.set("lines", "words", {});
    CHECK(idle_options(defaults).empty());
}

TEST_CASE("two sources, or none, are told", "[unit]") {
    CHECK_THROWS_WITH(target_recipe(options({{"target", "a.png"}, {"text", "A"}})),
                      "both 'target' and 'text' are given; expected one of them, so leave one out");
    CHECK_THROWS_WITH(target_recipe(options({{"gaps", 0.0}})),
                      "there is nothing to inscribe; give 'text', 'target' or 'gaps'");
}
