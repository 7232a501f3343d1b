#include "scene/node.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace orbweaver;

TEST_CASE("a value is shown and named as a sentence needs it", "[unit]") {
    struct Case {
        Node node;
        const char* kind;
        std::string text;
    };
    const Case cases[] = {
        {{true, {}}, "a boolean", "true"},
        {{std::int64_t{-7}, {}}, "an integer", "-7"},
        {{0.5, {}}, "a number", "0.5"},
        {{2.0, {}}, "a number", "2.0"},
        {{1e300, {}}, "a number", "1e+300"},
        {{std::numeric_limits<double>::quiet_NaN(), {}}, "a number", "nan"},
        {{-std::numeric_limits<double>::infinity(), {}}, "a number", "-inf"},
        {{std::string("7 mm"), {}}, "a text", "\"7 mm\""},
        {{std::string(60, 'x'), {}}, "a text", "\"" + std::string(60, 'x') + "\""},
        {{std::string(61, 'x'), {}}, "a text", "\"" + std::string(57, 'x') + "...\""},
        {{"x" + std::string("\xC3\xA9") + std::string(60, 'y'), {}},
         "a text",
         "\"x\xC3\xA9" + std::string(54, 'y') + "...\""},
        {{std::string(56, 'x') + "\xC3\xA9yyyy", {}}, "a text", "\"" + std::string(56, 'x') + "...\""},
        {{Array{Node{true, {}}, Node{}}, {}}, "an array", "an array of 2"},
        {{Table{{"a", {}, Node{}}}, {}}, "a table", "a table of 1 keys"},
    };
    for (const Case& c : cases) {
        CHECK(show(c.node) == c.text);
        CHECK(std::string(kind_of(c.node)) == c.kind);
    }
}

TEST_CASE("members are found by key, and can be changed", "[unit]") {
    Table table{{"a", {}, Node{std::int64_t{1}, {}}}, {"b", {}, Node{std::int64_t{2}, {}}}};
    REQUIRE(find(table, "b") != nullptr);
    find(table, "b")->value = std::int64_t{3};
    CHECK(show(table[1].node) == "3");
    CHECK(find(table, "c") == nullptr);
}
