#include "scene/overrides.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

Node scene() {
    return read_toml_text("[scene]\nseed = 1\n[[web]]\ndrag = 1\n[[web]]\ndrag = 2\n[view]\nsize = [3, 4]\n",
                          "s.toml");
}

/// The value at a path of keys and indices, shown.
std::string at(const Node& root, std::initializer_list<const char*> path) {
    const Node* node = &root;
    for (const char* key : path) {
        if (const Array* array = node->array())
            node = &(*array)[std::stoul(key)];
        else
            node = find(*node->table(), key);
        REQUIRE(node != nullptr);
    }
    return show(*node);
}

}  // namespace

TEST_CASE("an override changes what is there and makes what is not", "[unit]") {
    Node root = scene();
    apply_override(root, "scene.seed=7");
    apply_override(root, "scene.name=a = b");
    apply_override(root, "wind.model=thesis");
    apply_override(root, "view.camera.fov=\"50 deg\"");
    apply_override(root, "view.size.1=600");
    apply_override(root, "view.on=true");
    apply_override(root, "view.list=[1, 2.5]");
    CHECK(at(root, {"scene", "seed"}) == "7");
    CHECK(at(root, {"scene", "name"}) == "\"a = b\"");
    CHECK(at(root, {"wind", "model"}) == "\"thesis\"");
    CHECK(at(root, {"view", "camera", "fov"}) == "\"50 deg\"");
    CHECK(at(root, {"view", "size", "0"}) == "3");
    CHECK(at(root, {"view", "size", "1"}) == "600");
    CHECK(at(root, {"view", "on"}) == "true");
    CHECK(at(root, {"view", "list", "1"}) == "2.5");
}

TEST_CASE("a path into an array of tables means all of them, or the one it numbers", "[unit]") {
    Node root = scene();
    apply_override(root, "web.drag=5");
    CHECK(at(root, {"web", "0", "drag"}) == "5");
    CHECK(at(root, {"web", "1", "drag"}) == "5");
    apply_override(root, "web.1.drag=6");
    CHECK(at(root, {"web", "0", "drag"}) == "5");
    CHECK(at(root, {"web", "1", "drag"}) == "6");
}

TEST_CASE("an overridden value points at the option that gave it", "[unit]") {
    Node root = scene();
    apply_override(root, "view.size=[1, 2]");
    const Node* size = find(*find(*root.table(), "view")->table(), "size");
    CHECK(to_string(size->where) == "--set view.size");
    CHECK(to_string((*size->array())[1].where) == "--set view.size");
}

TEST_CASE("text that would be more than one value stays text", "[extreme]") {
    Node root = scene();
    apply_override(root, "scene.name=1\nother = 2");
    CHECK(at(root, {"scene", "name"}) == "\"1\nother = 2\"");
    apply_override(root, "scene.name=");
    CHECK(at(root, {"scene", "name"}) == "\"\"");
}

TEST_CASE("an override that leads nowhere is refused in words", "[extreme]") {
    struct Case {
        std::string assignment;
        const char* sentence;
    };
    const Case cases[] = {
        {"web.drag", "--set web.drag: expected path.to.key=value"},
        {"=1", "--set =1: expected path.to.key=value"},
        {"web..drag=1", "--set web..drag: the path has an empty key"},
        {".web=1", "--set .web: the path has an empty key"},
        {"web.=1", "--set web.: the path has an empty key"},
        {"web.2.drag=1", "--set web.2.drag: there is no element 2; expected 0 to 1"},
        {"scene.seed.deep=1", "--set scene.seed.deep: 'deep' lies below 1, which is not a table"},
    };
    for (const Case& c : cases) {
        Node root = scene();
        CHECK(fault_of([&] { apply_override(root, c.assignment); }) == c.sentence);
        CHECK(kind_of_fault([&] { apply_override(root, c.assignment); }) == FaultKind::invalid);
    }
    std::string deep = "a";
    for (int i = 0; i < 60000; ++i) deep += ".a";
    Node root = scene();
    CHECK(fault_of([&] { apply_override(root, deep + "=1"); }) ==
          "--set " + deep.substr(0, 40) + "...: the path names more than 64 tables");
}

TEST_CASE("an assignment has an equals sign and a path without empty keys", "[unit]") {
    for (const char* good : {"web.drag=1", "a=", "web.1.drag=a=b", "a=..", "a = .."})
        CHECK(is_assignment(good));
    for (const char* bad : {"", "foo", "=1", ".web=1", "web.=1", "a..b=1", "a.b"})
        CHECK_FALSE(is_assignment(bad));
}

TEST_CASE("a value is taken out wherever its path leads, and nothing else", "[unit]") {
    Node scene = read_toml_text("a = 1\n[[web]]\nx = 1\ny = 2\n[[web]]\nx.z = 3\n", "s.toml");
    remove_value(scene, "web.x");
    remove_value(scene, "web.none.of.these");
    remove_value(scene, "a.b");
    CHECK(find(*scene.table(), "a") != nullptr);
    const Array& webs = *find(*scene.table(), "web")->array();
    CHECK(find(*webs[0].table(), "x") == nullptr);
    CHECK(find(*webs[0].table(), "y") != nullptr);
    CHECK(webs[1].table()->empty());
}
