#include "bake.hpp"

#include <catch2/catch.hpp>

#include "obj.hpp"
#include "pictures.hpp"
#include "shapes.hpp"
#include "support/program.hpp"

using namespace orbweaver;
using test::run_assets;

namespace {

/// A scene that asks for a mesh through a module of which there is nothing but the manifest, another such
/// module for inscriptions, and a cache of its own.
class Stage {
public:
    Stage() {
        folder_.write("modules/walker.toml",
                      "id = \"walker\"\nversion = \"1\"\ntable = \"walker\"\nseveral = true\n"
                      "[options.mesh]\ntype = \"file\"\nasset = \"mesh\"\nmeaning = \"what it walks on\"\n");
        folder_.write("modules/scribe.toml",
                      "id = \"scribe\"\nversion = \"1\"\ntable = \"notice\"\n"
                      "[options.target]\ntype = \"file\"\nasset = \"target\"\nmeaning = \"a picture\"\n"
                      "[options.text]\ntype = \"text\"\nasset = \"target\"\nmeaning = \"words\"\n"
                      "[options.gaps]\ntype = \"number\"\nasset = \"target\"\nmeaning = \"a share\"\n"
                      "[options.invert]\ntype = \"boolean\"\nmeaning = \"what is bright\"\n");
        ::setenv("ORBWEAVER_CACHE", cache().c_str(), 1);
        write_mesh(mesh::cube(1, 2));
        write_scene("[[walker]]\nmesh = \"m.obj\"\n");
    }
    ~Stage() { ::unsetenv("ORBWEAVER_CACHE"); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void write_mesh(const mesh::RawMesh& raw) const { folder_.write("m.obj", obj_text(raw)); }
    void write_scene(const std::string& tables) const {
        folder_.write("scene.toml", "[scene]\nduration = 1\n" + tables);
    }
    test::Outcome bake() const {
        return run_assets({"bake", folder_.path("scene.toml"), "--modules", folder_.path("modules")});
    }
    std::string cache() const { return folder_.path("cache"); }
    std::vector<std::string> cached() const { return test::Folder::names_in(cache()); }
    const test::Folder& folder() const { return folder_; }

private:
    test::Folder folder_;
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a mesh is baked once, and again only when its source changes", "[unit]") {
    const Stage stage;
    const auto first = stage.bake();
    REQUIRE(first.code == 0);
    REQUIRE(stage.cached().size() == 1);
    const std::string file = stage.cache() + "/" + stage.cached()[0];
    CHECK(contains(first.out, "[1/1] walker.mesh: " + stage.folder().path("m.obj") + ": 48 triangles, "));
    CHECK(contains(first.out, ", baked: " + file));
    CHECK(contains(first.err, "bake 1/1 assets"));
    CHECK(contains(stage.bake().out, ", baked before: " + file));
    stage.write_mesh(mesh::cube(1, 3));
    CHECK(contains(stage.bake().out, ": 108 triangles, "));
    CHECK(stage.cached().size() == 2);
    stage.write_mesh(mesh::cube(1, 2));
    CHECK(contains(stage.bake().out, ", baked before: " + file));
}

TEST_CASE("a damaged file in the cache is made anew", "[unit]") {
    const Stage stage;
    REQUIRE(stage.bake().code == 0);
    const std::string file = "cache/" + stage.cached()[0];
    const std::string sound = test::read_file(stage.folder().path(file));
    stage.folder().write(file, sound.substr(0, sound.size() / 2));
    CHECK(contains(stage.bake().out, ", baked: "));
    CHECK(test::read_file(stage.folder().path(file)) == sound);
}

TEST_CASE("what is baked already is read as it is", "[unit]") {
    const Stage stage;
    REQUIRE(
        run_assets({"adjacency", stage.folder().path("m.obj"), "-o", stage.folder().path("m.baked")}).code ==
        0);
    stage.write_scene("[[walker]]\nmesh = \"m.baked\"\n");
    CHECK(contains(stage.bake().out, ": 48 triangles, "));
    CHECK(contains(stage.bake().out, ", baked, read as it is"));
    CHECK_FALSE(std::filesystem::exists(stage.cache()));
}

TEST_CASE("every mesh that cannot be baked is a fault with its place in the scene, and the others are baked",
          "[unit]") {
    const Stage stage;
    stage.folder().write("bad.obj", "v 0 0 0\n");
    stage.write_scene("[[walker]]\nmesh = \"bad.obj\"\n[[walker]]\nmesh = \"m.obj\"\n");
    const auto outcome = stage.bake();
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.err,
                   stage.folder().path("scene.toml") + ":4:8: " + stage.folder().path("bad.obj") + ": "));
    CHECK(contains(outcome.out, "[2/2] walker.2.mesh: "));
    CHECK(stage.cached().size() == 1);
}

TEST_CASE("what is to be inscribed is baked once for each recipe, from words, a picture or gaps", "[unit]") {
    const Stage stage;
    stage.write_scene("[notice]\ntext = \"SOME\\nPIG\"\ngaps = 0.1\n");
    const auto words = stage.bake();
    REQUIRE(words.code == 0);
    REQUIRE(stage.cached().size() == 1);  // words and gaps are one target
    CHECK(contains(words.out, "[1/1] notice.text: 600 x 600 pixels, baked: " + stage.cache() + "/"));
    CHECK(contains(stage.bake().out, "pixels, baked before: "));
    stage.folder().write("p.png", test::gray_png(9, 9, [](int x, int) { return x < 4 ? 0 : 255; }));
    stage.write_scene("[notice]\ntarget = \"p.png\"\n");
    CHECK(contains(stage.bake().out, ": " + stage.folder().path("p.png") + ": 600 x 600 pixels, baked: "));
    stage.write_scene("[notice]\ntarget = \"p.png\"\ninvert = true\n");
    CHECK(contains(stage.bake().out, ", baked: "));
    CHECK(stage.cached().size() == 3);
    REQUIRE(run_assets({"target", "--text", "A", "-o", stage.folder().path("a.baked")}).code == 0);
    stage.write_scene("[notice]\ntarget = \"a.baked\"\n");
    CHECK(contains(stage.bake().out, ": 600 x 600 pixels, baked, read as it is"));
    CHECK(stage.cached().size() == 3);
}

TEST_CASE("what cannot be inscribed is a fault with its place in the scene", "[unit]") {
    const Stage stage;
    const std::string scene = stage.folder().path("scene.toml");
    stage.folder().write("p.png", "not a picture");
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"text = \"\\u6f22\"\n", ":4:8: "},
        {"text = \"\"\n", ":4:8: the text is empty"},
        {"target = \"p.png\"\n", ":4:10: the file's first bytes are those of no picture format"},
        {"invert = true\ntext = \"A\"\n",
         ":4:10: 'invert' has no effect on words; expected it beside a picture; leave it out"},
        {"target = \"p.png\"\ntext = \"A\"\n", "both 'target' and 'text' are given"}};
    for (const auto& [option, sentence] : cases) {
        stage.write_scene("[notice]\n" + option);
        const auto outcome = stage.bake();
        INFO(outcome.err);
        CHECK(outcome.code == 3);
        CHECK(contains(outcome.err, scene + ":4:"));
        CHECK(contains(outcome.err, sentence));
    }
}
