#include "plan/scene_table.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

SceneInfo read(const std::string& text, Diagnostics& faults, const std::string& path = "there/meadow.toml") {
    return read_scene_table(read_toml_text(text, path), path, faults);
}

}  // namespace

TEST_CASE("a scene that says nothing of itself has the standard clock and gravity", "[unit]") {
    Diagnostics faults;
    const SceneInfo info = read("", faults);
    CHECK(faults.empty());
    CHECK(info.name == "meadow");
    CHECK(info.directory == "there");
    CHECK(info.duration == 10);
    CHECK(info.step == 1.0 / 60);
    CHECK(info.seed == 1);
    CHECK(info.gravity == Vec3{0, -9.81, 0});
    CHECK(read("", faults, "meadow.toml").directory == ".");
}

TEST_CASE("a scene's own clock, seed and gravity are taken", "[unit]") {
    Diagnostics faults;
    const SceneInfo info = read(
        "[scene]\nname = \"moon\"\nduration = \"2 min\"\nstep = \"1/120 s\"\nseed = 9\ngravity = [0, \"-162 "
        "cm/s^2\", 0]\n",
        faults);
    CHECK(sentences(faults) == std::vector<std::string>{});
    CHECK(info.name == "moon");
    CHECK(info.duration == 120);
    CHECK(info.step == 1.0 / 120);
    CHECK(info.seed == 9);
    CHECK(info.gravity == Vec3{0, -1.62, 0});
}

TEST_CASE("a clock that cannot run is refused with its place", "[extreme]") {
    struct Case {
        const char* line;
        const char* sentence;
    };
    const Case cases[] = {
        {"step = 0",
         "s.toml:2:8: 'step' is 0; expected a number of s, or a text such as \"1 s\", above 0 and at most "
         "100000"},
        {"step = nan",
         "s.toml:2:8: 'step' is nan; expected a number of s, or a text such as \"1 s\", above 0 and at most "
         "100000, finite"},
        {"step = \"1/0 s\"",
         "s.toml:2:8: 'step' is \"1/0 s\"; expected a number of s, or a text such as \"1 s\", above 0 and at "
         "most 100000, "
         "finite"},
        {"duration = -1",
         "s.toml:2:12: 'duration' is -1; expected a number of s, or a text such as \"1 s\", at least 0 and at "
         "most 1000000"},
        {"duration = \"3 kg\"",
         "s.toml:2:12: 'duration' is \"3 kg\", which is not a quantity of s; expected a number of s, or a text "
         "such as "
         "\"1 s\", at least 0 and at most 1000000"},
        {"seed = -1", "s.toml:2:8: 'seed' is -1; expected an integer at least 0"},
        {"seed = 1.5", "s.toml:2:8: 'seed' is 1.5; expected an integer at least 0"},
        {"gravity = 9.81", "s.toml:2:11: 'gravity' is 9.81; expected [x, y, z]"},
    };
    for (const Case& c : cases) {
        Diagnostics faults;
        read("[scene]\n" + std::string(c.line) + "\n", faults, "s.toml");
        CHECK(sentences(faults) == std::vector<std::string>{c.sentence});
    }
    Diagnostics faults;
    read("scene = 3\n", faults, "s.toml");
    read("[[scene]]\n", faults, "s.toml");
    CHECK(sentences(faults) == std::vector<std::string>{"s.toml:1:9: this is 3; expected a table",
                                                        "s.toml:1:1: this is an array of 1; expected a table"});
}

TEST_CASE("more frames than anybody could wait for are refused", "[extreme]") {
    for (const char* text :
         {"[scene]\nduration = 1\nstep = 1e-300\n", "[scene]\nduration = 1e6\nstep = 1e-12\n"}) {
        Diagnostics faults;
        read(text, faults);
        REQUIRE(faults.size() == 1);
        CHECK(to_string(faults.front()).find("expected at most 1e+09; take longer frames, or fewer") !=
              std::string::npos);
        CHECK(faults.front().where.line == 3);
    }
}
