#include "target_cache.hpp"

#include <catch2/catch.hpp>

#include "bitmaps.hpp"
#include "cache_environment.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"
#include "target_file.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// A cache of its own, and a picture.
struct Stage {
    Stage() {
        ::setenv("ORBWEAVER_CACHE", folder.path("cache").c_str(), 1);
        recipe.picture = folder.write("a.png", "bytes");
    }
    void bake(const std::string& path) const {
        write_target(path, test::random_bitmap(32, 32, 0.2, 1), source_hash(recipe), recipe_text(recipe));
    }

    test::CacheEnvironment environment;
    test::Scratch folder;
    TargetRecipe recipe;
};

}  // namespace

TEST_CASE("another source or another recipe has another place, another name of the source has not", "[unit]") {
    const Stage stage;
    const std::string path = cached_path(stage.recipe);
    TargetRecipe other = stage.recipe;
    other.picture = stage.folder.write("b.png", "bytes");
    CHECK(cached_path(other) == path);
    other.picture = stage.folder.write("b.png", "other bytes");
    CHECK(cached_path(other) != path);
    other = stage.recipe;
    other.invert = true;
    CHECK(cached_path(other) != path);
}

TEST_CASE("what was baked is found until its source changes, and not when it is damaged", "[unit]") {
    const Stage stage;
    const std::string path = cached_path(stage.recipe);
    CHECK_FALSE(find_cached(stage.recipe));
    stage.bake(path);
    REQUIRE(find_cached(stage.recipe));
    CHECK(open_target(stage.recipe).path() == path);
    stage.folder.write("a.png", "changed");
    CHECK_FALSE(find_cached(stage.recipe));
    stage.folder.write("a.png", "bytes");
    stage.folder.write("cache/" + path.substr(path.rfind('/') + 1), "ORBWBAKE");
    CHECK_FALSE(find_cached(stage.recipe));
    CHECK_THROWS_WITH(
        open_target(stage.recipe),
        stage.folder.path("a.png") + ": was baked, but what is kept of it cannot be used (" + path +
            ": is truncated: it has 8 bytes, less than a header; bake it again with orbweaver-assets); "
            "orbweaver-assets bake, with this scene, makes it anew in the cache");
}

TEST_CASE("a baked file is opened where it lies, and what is not baked is told with its remedy", "[unit]") {
    Stage stage;
    const std::string remedy =
        ": is not baked yet; run orbweaver-assets bake with this scene, or bake it with orbweaver-assets "
        "target and "
        "name the baked file";
    CHECK_THROWS_WITH(open_target(stage.recipe), stage.folder.path("a.png") + remedy);
    TargetRecipe text;
    text.text = "SOME PIG";
    CHECK_THROWS_WITH(open_target(text), "the text 'SOME PIG'" + remedy);
    text.text = "SOME\nPIG";
    CHECK_THROWS_WITH(open_target(text), "the text 'SOME\\nPIG'" + remedy);
    stage.bake(stage.folder.path("mine.baked"));
    stage.recipe.picture = stage.folder.path("mine.baked");
    CHECK(target_in(open_target(stage.recipe)).width == 32);
}
