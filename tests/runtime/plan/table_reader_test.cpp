#include "plan/table_reader.hpp"

#include <catch2/catch.hpp>

#include "scene/toml_reader.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

TEST_CASE("members are taken by name and type", "[unit]") {
    const Node node =
        read_toml_text("a = true\nb = 3\nc = \"x\"\nd = [\"y\", \"z\"]\ne = 2\nf = 2.5\n", "t.toml");
    Diagnostics faults;
    TableReader reader(node, faults);
    bool a = false;
    std::int64_t b = 0;
    std::string c;
    std::vector<std::string> d;
    double e = 0;
    double f = 0;
    double none = 7;
    reader.take("a", a);
    reader.take("b", b);
    reader.take("c", c);
    reader.take("d", d);
    CHECK(reader.take_number("e", e));
    CHECK(reader.take_number("f", f));
    CHECK_FALSE(reader.take_number("none", none));
    CHECK(reader.take("none") == nullptr);
    reader.finish();
    CHECK(faults.empty());
    CHECK(a);
    CHECK(b == 3);
    CHECK(c == "x");
    CHECK(d == std::vector<std::string>{"y", "z"});
    CHECK(e == 2);
    CHECK(f == 2.5);
    CHECK(none == 7);
}

TEST_CASE("members of another type, and those that nobody took, are faults", "[extreme]") {
    const Node node = read_toml_text("a = 1\nb = \"x\"\nc = [1]\nd = \"y\"\n", "t.toml");
    Diagnostics faults;
    TableReader reader(node, faults);
    bool a = false;
    double b = 0;
    std::vector<std::string> c;
    reader.take("a", a);
    reader.take_number("b", b);
    reader.take("c", c);
    reader.missing("e");
    reader.finish();
    CHECK(sentences(faults) ==
          std::vector<std::string>{
              "t.toml:1:5: 'a' is 1; expected a boolean", "t.toml:2:5: 'b' is \"x\"; expected a number",
              "t.toml:3:6: 'c' is 1; expected a text", "t.toml:1:1: 'e' is missing; expected a text",
              "t.toml:4:1: a manifest has no key 'd'; expected a, b or c"});
}

TEST_CASE("a fault names what the table is of", "[unit]") {
    const Node node = read_toml_text("a = 1\n", "t.toml");
    Diagnostics faults;
    TableReader reader(node, faults, "a bone");
    reader.take("length");
    reader.finish();
    CHECK(sentences(faults) == std::vector<std::string>{"t.toml:1:1: a bone has no key 'a'; expected length"});
}
