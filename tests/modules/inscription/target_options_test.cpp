#include "target_options.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"

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

TEST_CASE("two sources, or none, are told", "[unit]") {
    CHECK_THROWS_WITH(target_recipe(options({{"target", "a.png"}, {"text", "A"}})),
                      "both 'target' and 'text' are given; expected one of them, so leave one out");
    CHECK_THROWS_WITH(target_recipe(options({{"gaps", 0.0}})),
                      "there is nothing to inscribe; give 'text', 'target' or 'gaps'");
}
