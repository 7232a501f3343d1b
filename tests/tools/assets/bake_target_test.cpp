#include "bake_target.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "gaps.hpp"
#include "orbweaver/fault.hpp"
#include "pictures.hpp"
#include "support/folder.hpp"
#include "target_file.hpp"
#include "target_text.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

BakedFile open(const std::string& path) { return {path, kTargetType, kTargetVersion}; }

TargetRecipe some_pig() {
    TargetRecipe recipe;
    recipe.text = "SOME\nPIG";
    return recipe;
}

}  // namespace

TEST_CASE("a recipe gives the same bytes every time, by whatever name its picture goes", "[unit]") {
    const test::Folder folder;
    bake_target(some_pig(), folder.path("a"));
    bake_target(some_pig(), folder.path("b"));
    CHECK(test::read_file(folder.path("a")) == test::read_file(folder.path("b")));
    const std::string png =
        test::gray_png(70, 50, [](int x, int y) { return static_cast<std::uint8_t>(x * y); });
    TargetRecipe one, other;
    one.picture = folder.write("one.png", png);
    other.picture = folder.write("other.png", png);
    bake_target(one, folder.path("a"));
    bake_target(other, folder.path("b"));
    CHECK(test::read_file(folder.path("a")) == test::read_file(folder.path("b")));
}

TEST_CASE("gaps come in addition to words, or alone", "[unit]") {
    const test::Folder folder;
    TargetRecipe recipe = some_pig();
    recipe.gaps = 0.1;
    recipe.seed = 4;
    const Bitmap text = text_coverage(recipe), gaps = random_gaps(600, 600, 0.1, 4);
    bake_target(recipe, folder.path("both"));
    recipe.text.reset();
    bake_target(recipe, folder.path("alone"));
    const BakedFile both = open(folder.path("both")), alone = open(folder.path("alone"));
    verify_target(both);
    const auto with_text = target_in(both).coverage, without = target_in(alone).coverage;
    bool right = true;
    for (std::size_t i = 0; i < text.values.size(); ++i) {
        right = right && with_text[i] == (text.values[i] | gaps.values[i]);
        right = right && without[i] == gaps.values[i];
    }
    CHECK(right);
}

TEST_CASE("what is baked already, or would be overwritten, is refused", "[unit]") {
    const test::Folder folder;
    bake_target(some_pig(), folder.path("a.baked"));
    TargetRecipe recipe;
    recipe.picture = folder.path("a.baked");
    CHECK_THROWS_WITH(bake_target(recipe, folder.path("b.baked")),
                      folder.path("a.baked") + ": is baked already; name what it was made from");
    recipe.picture = folder.write("p.png", test::gray_png(9, 9, [](int x, int) { return x < 4 ? 0 : 255; }));
    CHECK_THROWS_WITH(bake_target(recipe, folder.path("p.png")),
                      folder.path("p.png") + ": is what is to be baked; name another file to write");
}

TEST_CASE("the font is not written over, by whatever name it goes", "[unit]") {
    const test::Folder folder;
    TargetRecipe recipe = some_pig();
    const std::string bytes = test::read_file(find_font(recipe.font, recipe.weight));
    recipe.font = folder.write("f.ttf", bytes);
    std::filesystem::create_symlink(recipe.font, folder.path("link"));
    for (const std::string& output : {folder.path("f.ttf"), folder.path("link")})
        CHECK_THROWS_WITH(bake_target(recipe, output),
                          output + ": is the font that the words are drawn in; name another file to write");
    CHECK(test::read_file(recipe.font) == bytes);
}
