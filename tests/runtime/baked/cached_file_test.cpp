#include "baked/cached_file.hpp"

#include <catch2/catch.hpp>

#include "../../modules/cache_environment.hpp"
#include "../../modules/scratch.hpp"
#include "baked/baked_writer.hpp"

using namespace orbweaver;

TEST_CASE("a key has one place in the cache", "[unit]") {
    const test::CacheEnvironment environment;
    ::setenv("ORBWEAVER_CACHE", "/o", 1);
    CHECK(cached_path({1, 2}) == "/o/" + to_string(ContentHash{1, 2}) + ".baked");
    CHECK(cached_path({1, 2}) != cached_path({2, 1}));
}

TEST_CASE("what is cached is nothing, sound, or told to be damaged with its remedy", "[unit]") {
    const test::Scratch folder;
    const std::string path = folder.path("a.baked");
    const auto open = [&] { return open_cached(path, "thing", 1, "its source"); };
    CHECK_FALSE(open());
    BakedWriter("thing", 1, {}).write(path);
    REQUIRE(open());
    CHECK(open()->path() == path);
    CHECK_THROWS_WITH(
        open_cached(path, "thing", 2, "its source"),
        Catch::StartsWith("its source: was baked, but what is kept of it cannot be used (" + path) &&
            Catch::EndsWith("); orbweaver-assets bake, with this scene, makes it anew in the cache"));
    CHECK_FALSE(if_sound([&] { return open_cached(path, "thing", 2, "its source"); }));
    CHECK_THROWS_WITH(refuse_unbaked("a.obj", "adjacency"),
                      "a.obj: is not baked yet; run orbweaver-assets bake with this scene, or bake it with "
                      "orbweaver-assets adjacency and name the baked file");
}
