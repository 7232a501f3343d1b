#include "baked/cache_folder.hpp"

#include <catch2/catch.hpp>

#include "../../modules/cache_environment.hpp"

using namespace orbweaver;

TEST_CASE("the cache lies where the first of three variables says", "[unit]") {
    const test::CacheEnvironment environment;
    CHECK_THROWS_WITH(cache_folder(), "there is no folder for baked files; set ORBWEAVER_CACHE or HOME to one");
    ::setenv("HOME", "/h", 1);
    CHECK(cache_folder() == "/h/.cache/orbweaver");
    ::setenv("XDG_CACHE_HOME", "/x", 1);
    CHECK(cache_folder() == "/x/orbweaver");
    ::setenv("ORBWEAVER_CACHE", "/o", 1);
    CHECK(cache_folder() == "/o");
}
