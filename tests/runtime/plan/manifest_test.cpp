#include "plan/manifest.hpp"

#include <catch2/catch.hpp>

#include "support/manifests.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

std::vector<std::string> faults_of(const std::string& text) {
    Diagnostics faults;
    const auto manifest = parse_manifest(text, "m.toml", faults);
    CHECK(manifest.has_value() == faults.empty());
    std::vector<std::string> all;
    for (const Diagnostic& fault : faults) all.push_back(to_string(fault));
    return all;
}

}  // namespace

TEST_CASE("a manifest says everything that its text says", "[unit]") {
    const std::string text = R"(id = "web"
version = "0.1.0"
summary = "webs"
table = "web"
several = true
when = "pictures"
provides = ["threads/1"]
needs = ["a/1"]
uses = ["b/1", "c/1"]
collects = ["d/1"]
meets = ["e/1"]
phases = ["sense", "present"]
libraries = ["Eigen"]

[options."camera.fov"]
type = "number"
unit = "deg"
default = 50
above = 0
below = 180
meaning = "angle of view"
plan = "seen at an angle"
[options.size]
type = "numbers"
length = 2
min = 1
max = 9
required = true
meaning = "pixels"
)";
    Diagnostics faults;
    const auto manifest = parse_manifest(text, "m.toml", faults);
    REQUIRE(manifest);
    CHECK(manifest->id == "web");
    CHECK(manifest->version == "0.1.0");
    CHECK(manifest->summary == "webs");
    CHECK(manifest->table == "web");
    CHECK(manifest->several);
    CHECK(manifest->when == "pictures");
    CHECK(manifest->provides == std::vector<std::string>{"threads/1"});
    CHECK(manifest->needs == std::vector<std::string>{"a/1"});
    CHECK(manifest->uses == std::vector<std::string>{"b/1", "c/1"});
    CHECK(manifest->collects == std::vector<std::string>{"d/1"});
    CHECK(manifest->meets == std::vector<std::string>{"e/1"});
    CHECK(manifest->phases == std::vector<Phase>{Phase::sense, Phase::present});
    CHECK(manifest->libraries == std::vector<std::string>{"Eigen"});
    CHECK(manifest->text == text);
    REQUIRE(manifest->options.size() == 2);
    const OptionSpec& fov = manifest->options[0];
    CHECK(fov.key == "camera.fov");
    CHECK(fov.type == OptionType::number);
    CHECK(fov.unit == "deg");
    CHECK(fov.meaning == "angle of view");
    CHECK(fov.plan == "seen at an angle");
    CHECK(range_text(fov) == "above 0 and below 180");
    const OptionSpec& size = manifest->options[1];
    CHECK(size.length == 2);
    CHECK(size.required);
    CHECK_FALSE(size.default_value);
    CHECK(range_text(size) == "at least 1 and at most 9");
    CHECK(range_text(OptionSpec{}) == "");
}

TEST_CASE("a manifest that is wrong says where and how", "[extreme]") {
    struct Case {
        const char* name;
        const char* text;
        std::vector<std::string> faults;
    };
    const Case cases[] = {
        {"empty",
         "",
         {"m.toml:1:1: 'id' is missing; expected a text", "m.toml:1:1: 'version' is missing; expected a text"}},
        {"types",
         "id = 1\nversion = true\nseveral = \"yes\"\nneeds = \"a/1\"\nuses = [1]\n",
         {"m.toml:1:6: 'id' is 1; expected a text", "m.toml:2:11: 'version' is true; expected a text",
          "m.toml:3:11: 'several' is \"yes\"; expected a boolean",
          "m.toml:4:9: 'needs' is \"a/1\"; expected an array of texts",
          "m.toml:5:9: 'uses' is 1; expected a text", "m.toml:1:1: 'id' is missing; expected a text",
          "m.toml:1:1: 'version' is missing; expected a text"}},
        {"phase",
         "id = \"a\"\nversion = \"1\"\nphases = [\"dance\"]\n",
         {"m.toml:1:1: there is no phase 'dance'; expected sense, act, integrate, constrain, derive, present"}},
        {"when",
         "id = \"a\"\nversion = \"1\"\nwhen = \"later\"\n",
         {"m.toml:1:1: 'when' is \"later\"; expected one of pictures, offscreen, window, recording, threads"}},
        {"unknown key",
         "id = \"a\"\nversion = \"1\"\ncolour = 3\n",
         {"m.toml:3:1: a manifest has no key 'colour'; expected id, version, summary, table, several, when, "
          "provides, "
          "needs, uses, collects, meets, libraries, phases, options or study"}},
        {"options no table",
         "id = \"a\"\nversion = \"1\"\noptions = 3\n",
         {"m.toml:3:11: 'options' is 3; expected a table"}},
        {"option no table",
         "id = \"a\"\nversion = \"1\"\n[options]\nx = 3\n",
         {"m.toml:4:5: option 'x' is 3; expected a table"}},
        {"option type",
         "id = \"a\"\nversion = \"1\"\n[options.x]\ntype = \"colour\"\nunit = \"parsec\"\nlength = -1\n",
         {"m.toml:3:1: option 'x' has no type 'colour'; expected one of boolean, integer, number, text, "
          "choice, vector, "
          "vectors, numbers, file, preset, named",
          "m.toml:3:1: option 'x' has the unknown unit 'parsec'",
          "m.toml:3:1: option 'x' has a length of -1; expected a count",
          "m.toml:3:1: 'meaning' is missing; expected a text"}},
        {"option asset",
         "id = \"a\"\nversion = \"1\"\n[options.x]\ntype = \"text\"\nasset = \"mesh\"\nmeaning = \"m\"\n"
         "[options.y]\ntype = \"file\"\nasset = \"song\"\nmeaning = \"m\"\n",
         {"m.toml:3:1: option 'x' has the asset 'mesh'; expected \"mesh\", of an option of type file, or "
          "\"target\"",
          "m.toml:7:1: option 'y' has the asset 'song'; expected \"mesh\", of an option of type file, or "
          "\"target\""}},
        {"default of a name of the scene's",
         "id = \"a\"\nversion = \"1\"\n[options.\"m.*.x\"]\ntype = \"number\"\ndefault = 1\nmeaning = \"m\"\n",
         {"m.toml:3:1: option 'm.*.x' has a default or is required; expected neither, of an option whose name "
          "the "
          "scene gives"}},
        {"not TOML",
         "id = ",
         {"m.toml:1:6: Error while parsing key-value pair: encountered end-of-file; expected TOML"}},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        CHECK(faults_of(c.text) == c.faults);
    }
}

TEST_CASE("a manifest that cannot be read is a fault, not the end", "[extreme]") {
    const Folder folder;
    Diagnostics faults;
    CHECK_FALSE(read_manifest(folder.path("none.toml"), faults));
    std::filesystem::create_directory(folder.path("folder.toml"));
    CHECK_FALSE(read_manifest(folder.path("folder.toml"), faults));
    REQUIRE(faults.size() == 2);
    CHECK(to_string(faults[0]) ==
          folder.path("none.toml") + ": this manifest cannot be read; expected a TOML file");
    CHECK(to_string(faults[1]) ==
          folder.path("folder.toml") + ": this manifest cannot be read; expected a TOML file");
}
