#include "orbweaver/diagnostic.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver;

TEST_CASE("a diagnostic says as much as it knows, and no more", "[unit]") {
    struct Case {
        Diagnostic fault;
        const char* text;
    };
    const Case cases[] = {
        {{{"a.toml", 3, 8}, "'x' is 1", "a text", "write one"},
         "a.toml:3:8: 'x' is 1; expected a text; write one"},
        {{{"a.toml", 3, 8}, "'x' is 1", "", "write one"}, "a.toml:3:8: 'x' is 1; write one"},
        {{{"a.toml", 0, 0}, "'x' is 1", "a text", ""}, "a.toml: 'x' is 1; expected a text"},
        {{{}, "out of paper", "", ""}, "out of paper"},
    };
    for (const Case& c : cases) CHECK(to_string(c.fault) == c.text);
}
