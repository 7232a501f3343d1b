#include "scene/toml_reader.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    all.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

constexpr const char* kTooDeep = "s.toml:1: a key nests more than 64 tables; write a flatter scene";

}  // namespace

TEST_CASE("values, keys and elements know the place they were written at", "[unit]") {
    const Node root = read_toml_text(
        "[web]\n  drag = 1.5\nlist = [1,\n  \"two\"]\n[[spider]]\n[[spider]]\nfast = true\n", "s.toml");
    const Node* web = find(*root.table(), "web");
    REQUIRE(web != nullptr);
    const Member& drag = web->table()->front();
    CHECK(drag.key == "drag");
    CHECK(to_string(drag.where) == "s.toml:2:3");
    CHECK(to_string(drag.node.where) == "s.toml:2:10");
    CHECK(std::get<double>(drag.node.value) == 1.5);
    const Array& list = *find(*web->table(), "list")->array();
    CHECK(to_string(list[1].where) == "s.toml:4:3");
    const Array& spiders = *find(*root.table(), "spider")->array();
    REQUIRE(spiders.size() == 2);
    CHECK(std::get<bool>(find(*spiders[1].table(), "fast")->value));
}

TEST_CASE("what is not TOML is refused with its place", "[extreme]") {
    struct Case {
        const char* name;
        std::string text;
        const char* place;
    };
    const Case cases[] = {
        {"unclosed table", "a = 1\n[web\n", "s.toml:2:5: "},
        {"no value", "a = 1\nb =\n", "s.toml:2:4: "},
        {"twice the same key", "a = 1\na = 2\n", "s.toml:2:5: "},
        {"a date", "a = 1\nday = 2020-01-02\n", "s.toml:2:7: dates and times mean nothing here; expected"},
        {"an image", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "s.toml:1:1: "},
        {"bad UTF-8", "a = \"\xff\xfe\"\n", "s.toml:1:5: "},
        {"zeros", std::string(1000, '\0'), "s.toml:1:1: "},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const auto read = [&] { read_toml_text(c.text, "s.toml"); };
        CHECK_THAT(fault_of(read), Catch::StartsWith(c.place));
        CHECK(kind_of_fault(read) == FaultKind::invalid);
    }
}

TEST_CASE("nesting without end is refused before it can hurt", "[extreme]") {
    struct Case {
        const char* name;
        std::string text;
    };
    const Case cases[] = {
        {"dotted key", repeated("a.", 500000) + "a = 1"},
        {"table header", "[" + repeated("a.", 500000) + "a]"},
        {"brackets", repeated("[", 400000)},
        {"array of arrays", "a = " + repeated("[", 400000)},
        {"inline tables", "a = " + repeated("{a=", 300000)},
        {"inline tables of dotted keys",
         "a = " + repeated("{" + repeated("a.", 60) + "a = ", 200) + "1" + repeated("}", 200)},
        {"behind quoted keys", repeated("\"a\".", 200000) + "a = 1"},
        {"behind a closed text", "a = [\"\"\" \" \"\"\", {" + repeated("b.", 400000) + "b = 1}]"},
        {"behind a literal text", "a = [''' ' ''', {" + repeated("b.", 400000) + "b = 1}]"},
        {"behind an escape", "a = [\"\\\"\", {" + repeated("b.", 400000) + "b = 1}]"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const auto read = [&] { read_toml_text(c.text, "s.toml"); };
        CHECK(fault_of(read) == kTooDeep);
        CHECK(kind_of_fault(read) == FaultKind::limit);
    }
}

TEST_CASE("dots that nest nothing are no depth", "[extreme]") {
    const std::string dots(200, '.');
    for (const std::string& text :
         {"# " + dots + "\na = 1\n", "a = \"" + dots + "\"\n", "a = '" + dots + "'\n",
          "a = \"\"\"\n" + dots + "\n\"\"\"\n", "a = '''" + dots + "'''\n",
          "a = [" + repeated("1.5, ", 500) + "]\n", "a = [" + repeated("[1.5, 2.5],\n", 500) + "]\n",
          repeated("[a.b]\nc.d = 1.5\n", 1) + repeated("# it's\n", 100) + "[e.f]\ng.h = {i.j = 2.5}\n"}) {
        CAPTURE(text.substr(0, 40));
        CHECK_NOTHROW(read_toml_text(text, "s.toml"));
    }
}

TEST_CASE("the deepest key that is allowed can be read", "[unit]") {
    CHECK_NOTHROW(read_toml_text(repeated("a.", kMaxKeyDepth) + "a = 1", "s.toml"));
    CHECK(fault_of([] { read_toml_text(repeated("a.", kMaxKeyDepth + 1) + "a = 1", "s.toml"); }) == kTooDeep);
}

TEST_CASE("a scene of many megabytes is refused by its size", "[extreme]") {
    const Folder folder;
    const std::string text = repeated("[a.b.c.d.e.f.g.h]\n", 600000);
    const std::string path = folder.write("large.toml", text);
    const auto read = [&] { read_toml_file(path); };
    CHECK(fault_of(read) ==
          path +
              ": the file has 10800000 bytes and the limit is 1048576; keep large data in files of "
              "its own (a network, a mesh) and name them");
    CHECK(kind_of_fault(read) == FaultKind::limit);
    CHECK(kind_of_fault([&] { read_toml_text(text, "s.toml"); }) == FaultKind::limit);
}

TEST_CASE("a path that is no readable file is refused by what it is", "[extreme]") {
    const Folder folder;
    const std::string none = folder.path("none.toml");
    CHECK(fault_of([&] { read_toml_file(none); }) ==
          none + ": there is no such file; expected a TOML file; check the path");
    CHECK(fault_of([&] { read_toml_file(folder.path()); }) ==
          folder.path() + ": this is not a regular file; expected a TOML file; check the path");
    const std::string fifo = folder.path("fifo.toml");
    REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
    CHECK(fault_of([&] { read_toml_file(fifo); }) ==
          fifo + ": this is not a regular file; expected a TOML file; check the path");
    // A regular file that even root cannot read: the system answers with an input/output error.
    CHECK(fault_of([] { read_toml_file("/proc/self/mem"); }) == "/proc/self/mem: cannot be read");
}

TEST_CASE("an empty file is an empty scene", "[extreme]") {
    const Folder folder;
    CHECK(read_toml_file(folder.write("empty.toml", "")).table()->empty());
    CHECK(read_toml_file(folder.write("bom.toml",
                                      "\xEF\xBB\xBF"
                                      "a = 1\r\n"))
              .table()
              ->size() == 1);
}
