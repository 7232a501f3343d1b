#include "scene/nearest_name.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace orbweaver;

TEST_CASE("a slip of the finger finds the name that was meant", "[unit]") {
    const std::vector<std::string> names{"web", "wind", "inscription", "spider", "crawler", "surface", "view"};
    struct Case {
        const char* wrong;
        const char* meant;
    };
    for (const Case& c : {Case{"spyder", "spider"}, Case{"wnid", "wind"}, Case{"inscripton", "inscription"},
                          Case{"surfaces", "surface"}, Case{"wep", "web"}, Case{"crawlre", "crawler"},
                          Case{"helicopter", ""}, Case{"zzzzzz", ""}}) {
        CAPTURE(c.wrong);
        CHECK(nearest_name(c.wrong, names) == c.meant);
    }
    CHECK(nearest_name("web", {}).empty());
    CHECK(nearest_name(std::string(1000000, 'w'), names).empty());
}

TEST_CASE("names are joined as a sentence would", "[unit]") {
    using Names = std::vector<std::string>;
    CHECK(join_names(Names{}) == "");
    CHECK(join_names(Names{"a"}) == "a");
    CHECK(join_names(Names{"a", "b"}) == "a or b");
    CHECK(join_names(Names{"a", "b", "c"}) == "a, b or c");
    CHECK(join_names(Names{"a", "b", "c"}, " and ") == "a, b and c");
}
