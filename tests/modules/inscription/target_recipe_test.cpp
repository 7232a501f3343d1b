#include "target_recipe.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

TargetRecipe of_text(const std::string& text) {
    TargetRecipe recipe;
    recipe.text = text;
    return recipe;
}

}  // namespace

TEST_CASE("a recipe says what it is made of and nothing that does not matter to it", "[unit]") {
    CHECK(recipe_text(of_text("SOME\nPIG")) ==
          "source: text\nsize: 600 x 600\nmargin: 0.05\ntext: SOME\\nPIG\nfont: DejaVuSans-Bold.ttf\n"
          "weight: bold\nalign: center\nline_spacing: 1\n");
    TargetRecipe picture;
    picture.picture = "any.png";
    CHECK(recipe_text(picture) ==
          "source: picture\nsize: 600 x 600\nmargin: 0\nthreshold: otsu\ninvert: no\nlow_pass: 0\n");
    TargetRecipe gaps;
    gaps.gaps = 0.1;
    gaps.seed = 5;
    CHECK(recipe_text(gaps) == "source: gaps\nsize: 600 x 600\ngaps: 0.1\nseed: 5\n");
}

TEST_CASE("whatever changes a target changes its recipe", "[unit]") {
    const test::Scratch folder;
    TargetRecipe picture;
    picture.picture = folder.write("a.png", "bytes");
    const std::vector<void (*)(TargetRecipe&)> changes = {[](TargetRecipe&) {},
                                                          [](TargetRecipe& r) { r.width = 601; },
                                                          [](TargetRecipe& r) { r.height = 601; },
                                                          [](TargetRecipe& r) { r.margin = 0.1; },
                                                          [](TargetRecipe& r) { r.threshold = 0.5; },
                                                          [](TargetRecipe& r) { r.invert = true; },
                                                          [](TargetRecipe& r) { r.low_pass = 1; },
                                                          [](TargetRecipe& r) { r.gaps = 0.1; },
                                                          [](TargetRecipe& r) {
                                                              r.gaps = 0.1;
                                                              r.seed = 2;
                                                          },
                                                          [](TargetRecipe& r) {
                                                              r.picture.reset();
                                                              r.text = "a";
                                                          },
                                                          [](TargetRecipe& r) {
                                                              r.picture.reset();
                                                              r.text = "a";
                                                              r.weight = FontWeight::regular;
                                                          },
                                                          [](TargetRecipe& r) {
                                                              r.picture.reset();
                                                              r.text = "a";
                                                              r.align = Align::right;
                                                          },
                                                          [](TargetRecipe& r) {
                                                              r.picture.reset();
                                                              r.text = "a";
                                                              r.line_spacing = 2;
                                                          }};
    std::set<std::string> texts;
    for (const auto& change : changes) {
        TargetRecipe changed = picture;
        change(changed);
        texts.insert(recipe_text(changed));
    }
    CHECK(texts.size() == changes.size());
}

TEST_CASE("the source is the picture's bytes, or the words and the font", "[unit]") {
    const test::Scratch folder;
    TargetRecipe a, b;
    a.picture = folder.write("a.png", "bytes");
    b.picture = folder.write("b.png", "bytes");
    CHECK(source_hash(a) == source_hash(b));
    b.picture = folder.write("b.png", "other");
    CHECK_FALSE(source_hash(a) == source_hash(b));
    CHECK(source_hash(of_text("a")) == source_hash(of_text("a")));
    CHECK_FALSE(source_hash(of_text("a")) == source_hash(of_text("b")));
    TargetRecipe other = of_text("a");
    other.font = folder.write("f.ttf", "another font");
    CHECK_FALSE(source_hash(of_text("a")) == source_hash(other));
}

TEST_CASE("words come back from a recipe as they were", "[unit]") {
    TargetRecipe recipe;
    for (const char* text : {"A", "SOME\nPIG", " a \n\n b", "a\\nb", "\\", "\\\n", "text: a", ""}) {
        recipe.text = text;
        CAPTURE(text);
        CHECK(words_in(recipe_text(recipe)) == text);
    }
    recipe.text.reset();
    recipe.gaps = 0.1;
    CHECK_FALSE(words_in(recipe_text(recipe)));
    recipe.picture = "text: a.png";
    CHECK_FALSE(words_in(recipe_text(recipe)));
    CHECK_FALSE(words_in(""));
}
