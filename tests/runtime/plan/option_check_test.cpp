#include "plan/option_check.hpp"

#include <catch2/catch.hpp>

#include "scene/overrides.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

constexpr const char* kManifest = R"(
id = "all"
version = "1"
[options.flag]
type = "boolean"
default = true
meaning = "m"
[options.count]
type = "integer"
default = 2
min = 1
max = 5
meaning = "m"
[options.drag]
type = "number"
unit = "N s/m"
default = "10 mN s/m"
above = 0
below = 1
meaning = "m"
[options.ratio]
type = "number"
default = 0.5
meaning = "m"
[options.angle]
type = "number"
unit = "deg"
default = 30
meaning = "m"
[options.name]
type = "text"
meaning = "m"
[options.mode]
type = "choice"
choices = ["calm", "steady", "thesis"]
default = "calm"
meaning = "m"
[options.place]
type = "vector"
unit = "m"
default = [0, 0, 0]
meaning = "m"
[options.anchors]
type = "vectors"
unit = "m"
meaning = "m"
[options.size]
type = "numbers"
length = 2
min = 1
default = [3, 4]
meaning = "m"
[options.weights]
type = "numbers"
unit = "kg"
meaning = "m"
[options.network]
type = "file"
meaning = "m"
[options.species]
type = "preset"
folder = "species"
meaning = "m"
[options.creature]
type = "named"
folder = "creatures"
meaning = "m"
[options."camera.fov"]
type = "number"
unit = "deg"
default = 50
meaning = "m"
[options."camera.lens.width"]
type = "number"
unit = "m"
default = 1
meaning = "m"
[options."material.*.friction"]
type = "number"
max = 10
meaning = "m"
[options."material.*.climbable"]
type = "boolean"
meaning = "m"
)";

const Manifest& manifest() {
    static const Manifest parsed = [] {
        Diagnostics faults;
        auto read = parse_manifest(kManifest, "all.toml", faults);
        REQUIRE(read);
        return std::move(*read);
    }();
    return parsed;
}

struct Checked {
    Diagnostics faults;
    Options options;

    explicit Checked(const std::string& table, const AssetPaths& paths = {})
        : options(check_options(read_toml_text(table, "s.toml"), manifest().options, paths, faults)) {}
};

constexpr const char* kNumberOfDrag = "a number of N s/m, or a text such as \"1 N s/m\", above 0 and below 1";

}  // namespace

TEST_CASE("absent options take their defaults in SI, or stay absent", "[unit]") {
    const Checked checked("");
    CHECK(sentences(checked.faults) == std::vector<std::string>{});
    CHECK(checked.options.flag("flag"));
    CHECK(checked.options.integer("count") == 2);
    CHECK(checked.options.number("drag") == 0.01);
    CHECK(checked.options.number("angle") == 30);
    CHECK(checked.options.text("mode") == "calm");
    CHECK(checked.options.numbers("size") == std::vector<double>{3, 4});
    CHECK(checked.options.number("camera.fov") == 50);
    CHECK_FALSE(checked.options.has("name"));
    CHECK_FALSE(checked.options.has("anchors"));
    CHECK_FALSE(checked.options.given("drag"));
}

TEST_CASE("values of every type arrive checked and in SI", "[unit]") {
    const Checked checked(R"(
flag = false
count = 5
drag = "2 cN s/m"
ratio = "3/4"
angle = "1 rad"
name = "seven"
mode = "thesis"
place = ["7 mm", 0.5, -1]
anchors = [[0, 0, 0], ["1 km", 2, 3]]
size = [640, 480]
weights = ["10 ug", 2]
camera = { fov = 60, lens.width = "3 cm" }
)");
    CHECK(sentences(checked.faults) == std::vector<std::string>{});
    const Options& options = checked.options;
    CHECK_FALSE(options.flag("flag"));
    CHECK(options.integer("count") == 5);
    CHECK(options.number("drag") == 0.02);
    CHECK(options.number("ratio") == 0.75);
    CHECK(options.number("angle") == Approx(57.29577951308232));
    CHECK(options.text("name") == "seven");
    CHECK(options.text("mode") == "thesis");
    CHECK(options.vector("place") == Vec3{0.007, 0.5, -1});
    CHECK(options.vectors("anchors") == std::vector<Vec3>{{0, 0, 0}, {1000, 2, 3}});
    CHECK(options.numbers("size") == std::vector<double>{640, 480});
    CHECK(options.numbers("weights") == std::vector<double>{1e-8, 2});
    CHECK(options.number("camera.fov") == 60);
    CHECK(options.number("camera.lens.width") == 0.03);
    CHECK(to_string(options.where("drag")) == "s.toml:4:8");
}

TEST_CASE("a value that is wrong is named with its place and what would be right", "[extreme]") {
    struct Case {
        const char* line;
        std::string sentence;
    };
    const Case cases[] = {
        {"flag = 1", "1:8: 'flag' is 1; expected true or false"},
        {"count = 6", "1:9: 'count' is 6; expected an integer at least 1 and at most 5"},
        {"count = 2.0", "1:9: 'count' is 2.0; expected an integer at least 1 and at most 5"},
        {"count = \"2\"", "1:9: 'count' is \"2\"; expected an integer at least 1 and at most 5"},
        {"drag = 0", std::string("1:8: 'drag' is 0; expected ") + kNumberOfDrag},
        {"drag = 1", std::string("1:8: 'drag' is 1; expected ") + kNumberOfDrag},
        {"drag = nan", std::string("1:8: 'drag' is nan; expected ") + kNumberOfDrag + ", finite"},
        {"drag = inf", std::string("1:8: 'drag' is inf; expected ") + kNumberOfDrag + ", finite"},
        {"drag = \"inf N s/m\"",
         std::string("1:8: 'drag' is \"inf N s/m\"; expected ") + kNumberOfDrag + ", finite"},
        {"drag = true", std::string("1:8: 'drag' is true; expected ") + kNumberOfDrag},
        {"drag = \"much\"", std::string("1:8: 'drag' is \"much\"; expected ") + kNumberOfDrag},
        {"drag = \"1 kg\"",
         std::string("1:8: 'drag' is \"1 kg\", which is not a quantity of N s/m; expected ") + kNumberOfDrag},
        {"ratio = \"1 m\"", "1:9: 'ratio' is \"1 m\", which is not a quantity of no unit; expected a number"},
        {"name = 3", "1:8: 'name' is 3; expected a text"},
        {"mode = \"stedy\"",
         "1:8: 'mode' is \"stedy\"; expected one of calm, steady or thesis; did you mean \"steady\"?"},
        {"mode = \"hurricane\"", "1:8: 'mode' is \"hurricane\"; expected one of calm, steady or thesis"},
        {"mode = 3", "1:8: 'mode' is 3; expected one of calm, steady or thesis"},
        {"place = [1, 2]", "1:9: 'place' is an array of 2; expected [x, y, z]"},
        {"place = [1, 2, nan]",
         "1:16: 'place' is nan; expected a number of m, or a text such as \"1 m\", finite"},
        {"place = [1, \"2 s\", 3]",
         "1:13: 'place' is \"2 s\", which is not a quantity of m; expected a number of m, or a text such as "
         "\"1 m\""},
        {"anchors = 3", "1:11: 'anchors' is 3; expected an array of [x, y, z]"},
        {"anchors = [[0, 0, 0], [1, 1]]", "1:23: 'anchors' is an array of 2; expected [x, y, z]"},
        {"size = [1, 2, 3]", "1:8: 'size' is an array of 3; expected an array of 2"},
        {"size = [1, 0]", "1:12: 'size' is 0; expected a number, at least 1"},
        {"network = 3", "1:11: 'network' is 3; expected the path of a file"},
        {"network = \"\"", "1:11: 'network' is \"\"; expected the path of a file"},
        {"drga = 1",
         "1:1: there is no option 'drga'; expected one of flag, count, drag, ratio, angle, name, mode, place, "
         "anchors, "
         "size, weights, network, species, creature, camera or material; did you mean 'drag'?"},
        {"camera.fow = 1",
         "1:8: there is no option 'camera.fow'; expected one of fov or lens; did you mean 'camera.fov'?"},
        {"camera = 1", "1:10: 'camera' is 1; expected a table"},
        {"species = 1", "1:11: 'species' is 1; expected a text"},
        {"species = \"none\"", "1:11: there is no species 'none'; expected a path ending in .toml"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.line);
        CHECK(sentences(Checked(c.line).faults) == std::vector<std::string>{"s.toml:" + c.sentence});
    }
}

TEST_CASE("an option that is required is missed with its meaning", "[unit]") {
    Diagnostics faults;
    OptionSpec spec;
    spec.key = "kind";
    spec.required = true;
    spec.meaning = "what crawls";
    const Options options = check_options(read_toml_text("", "s.toml"), std::span(&spec, 1), {}, faults);
    CHECK(sentences(faults) == std::vector<std::string>{"s.toml:1:1: 'kind' is missing; expected what crawls"});
    CHECK_FALSE(options.has("kind"));
}

TEST_CASE("the scene goes before its preset, and the preset before the defaults", "[unit]") {
    const Folder folder;
    folder.write("assets/species/araneus.toml", "count = 4\ndrag = 0.25\n[camera]\nfov = 70\n");
    const Checked checked("species = \"araneus\"\ncount = 3\n", {folder.path(), {folder.path("assets")}});
    CHECK(sentences(checked.faults) == std::vector<std::string>{});
    CHECK(checked.options.integer("count") == 3);
    CHECK(checked.options.number("drag") == 0.25);
    CHECK(checked.options.number("camera.fov") == 70);
    CHECK(checked.options.number("ratio") == 0.5);
    CHECK(checked.options.given("drag"));
    CHECK(to_string(checked.options.where("drag")) == folder.path("assets/species/araneus.toml") + ":2:8");
}

TEST_CASE("a preset is found by name in the first folder that has it, or by path", "[unit]") {
    const Folder folder;
    folder.write("one/species/a.toml", "count = 3\n");
    folder.write("two/species/a.toml", "count = 4\n");
    folder.write("mine.toml", "count = 5\n");
    const AssetPaths paths{folder.path(), {folder.path("one"), folder.path("two")}};
    CHECK(Checked("species = \"a\"\n", paths).options.integer("count") == 3);
    CHECK(Checked("species = \"mine.toml\"\n", paths).options.integer("count") == 5);
}

TEST_CASE("a preset that several folders have is offered once", "[unit]") {
    const Folder folder;
    folder.write("one/species/a.toml", "count = 3\n");
    folder.write("two/species/a.toml", "count = 4\n");
    folder.write("two/species/c.toml", "count = 4\n");
    const AssetPaths paths{folder.path(), {folder.path("one"), folder.path("two")}};
    const Diagnostics faults = Checked("species = \"b\"\n", paths).faults;
    REQUIRE(faults.size() == 1);
    CHECK_THAT(to_string(faults[0]), Catch::Contains("expected a or c, or a path ending in .toml"));
}

TEST_CASE("a named file's path is the option, and one that is not there is refused with the nearest",
          "[unit]") {
    const Folder folder;
    folder.write("assets/creatures/ant.toml", "anything = true\n");
    const AssetPaths paths{folder.path(), {folder.path("assets")}};
    CHECK(Checked("creature = \"ant\"\n", paths).options.text("creature") ==
          folder.path("assets/creatures/ant.toml"));
    const Diagnostics faults = Checked("creature = \"and\"\n", paths).faults;
    REQUIRE(faults.size() == 1);
    CHECK_THAT(to_string(faults[0]),
               Catch::Contains("there is no creature 'and'") && Catch::Contains("did you mean \"ant\"?"));
}

TEST_CASE("a preset that is wrong is a fault of its own file", "[extreme]") {
    const Folder folder;
    folder.write("species/araneus.toml", "");
    folder.write("species/zygiella.toml", "count = 9\n");
    folder.write("species/torn.toml", "count =\n");
    const AssetPaths paths{folder.path(), {folder.path()}};
    CHECK(sentences(Checked("species = \"araneas\"", paths).faults) ==
          std::vector<std::string>{
              "s.toml:1:11: there is no species 'araneas'; expected araneus, torn or zygiella, or a "
              "path ending in .toml; did you mean \"araneus\"?"});
    CHECK(sentences(Checked("species = \"zygiella\"", paths).faults) ==
          std::vector<std::string>{folder.path("species/zygiella.toml") +
                                   ":1:9: 'count' is 9; expected an integer at least 1 and at most 5"});
    const auto torn = sentences(Checked("species = \"torn\"", paths).faults);
    REQUIRE(torn.size() == 1);
    CHECK_THAT(torn.front(), Catch::StartsWith("s.toml:1:11: " + folder.path("species/torn.toml") + ":1:"));
}

TEST_CASE("a file is found from the scene's folder and arrives as an absolute path", "[unit]") {
    const Folder folder;
    folder.write("nets/a.json", "{}");
    const AssetPaths paths{folder.path("scenes"), {}};
    std::filesystem::create_directory(folder.path("scenes"));
    CHECK(Checked("network = \"../nets/a.json\"", paths).options.text("network") == folder.path("nets/a.json"));
    CHECK(Checked("network = \"" + folder.path("nets/a.json") + "\"", paths).options.text("network") ==
          folder.path("nets/a.json"));
    CHECK(sentences(Checked("network = \"b.json\"", paths).faults) ==
          std::vector<std::string>{
              "s.toml:1:11: 'network' is \"b.json\", and there is no such file; expected a file, its "
              "path starting at the scene's folder; looked at " +
              folder.path("scenes/b.json")});
    CHECK(sentences(Checked("network = \"../nets\"", paths).faults) ==
          std::vector<std::string>{
              "s.toml:1:11: 'network' is \"../nets\", and that is not a regular file; expected a "
              "file, its path starting at the scene's folder; looked at " +
              folder.path("nets")});
}

TEST_CASE("a value from the command line is at fault under its own name", "[unit]") {
    Node scene = read_toml_text("[all]\ncount = 2\n", "s.toml");
    apply_override(scene, "all.count=9");
    Diagnostics faults;
    check_options(*find(*scene.table(), "all"), manifest().options, {}, faults);
    CHECK(sentences(faults) ==
          std::vector<std::string>{
              "--set all.count: 'count' is 9; expected an integer at least 1 and at most 5"});
}

TEST_CASE("an option may lie in tables that the scene names as it likes", "[unit]") {
    const Checked checked(
        "[material.glass]\nfriction = 0.1\nclimbable = false\n[material.\"Rough.001\"]\nfriction = 2\n");
    CHECK(checked.faults.empty());
    CHECK(checked.options.names_in("material") == std::vector<std::string>{"Rough.001", "glass"});
    CHECK(checked.options.number("material.glass.friction") == 0.1);
    CHECK_FALSE(checked.options.flag("material.glass.climbable"));
    CHECK(checked.options.number("material.Rough.001.friction") == 2);
    CHECK_FALSE(checked.options.has("material.Rough.001.climbable"));
    CHECK(Checked("").options.names_in("material").empty());

    const Checked numbered("[[material]]\nfriction = 1\n[[material]]\nfriction = 2\nclimbable = true\n");
    CHECK(numbered.faults.empty());
    CHECK(numbered.options.names_in("material") == std::vector<std::string>{"0", "1"});
    CHECK(numbered.options.number("material.1.friction") == 2);
    const Checked odd("material = [{ friction = 1 }, 2]\n[[camera]]\nfov = 1\n");
    REQUIRE(odd.faults.size() == 2);
    CHECK(to_string(odd.faults[0]) == "s.toml:1:31: 'material.1' is 2; expected a table");
    CHECK(odd.faults[1].what == "'camera' is an array of 1");

    const Checked wrong("[material.glass]\nfriction = 11\nfrictoin = 1\n[material]\nice = 3\n");
    REQUIRE(wrong.faults.size() == 3);
    CHECK(to_string(wrong.faults[0]) ==
          "s.toml:2:12: 'material.glass.friction' is 11; expected a number, at most 10");
    CHECK(
        to_string(wrong.faults[1]) ==
        "s.toml:3:1: there is no option 'material.glass.frictoin'; expected one of friction or climbable; did "
        "you mean 'material.glass.friction'?");
    CHECK(to_string(wrong.faults[2]) == "s.toml:5:7: 'material.ice' is 3; expected a table");
}
