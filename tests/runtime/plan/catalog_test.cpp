#include "plan/catalog.hpp"

#include <stdlib.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "support/manifests.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

TEST_CASE("a catalog holds every manifest of its folders, by id", "[unit]") {
    ManifestFolder one;
    ManifestFolder other;
    one.add("web", "");
    one.add("ant", "");
    other.add("bee", "");
    const Catalog catalog = read_catalog({one.path(), other.path()});
    CHECK(catalog.faults.empty());
    REQUIRE(catalog.manifests.size() == 3);
    CHECK(catalog.manifests[0].id == "ant");
    CHECK(catalog.manifests[1].id == "bee");
    CHECK(catalog.manifests[2].id == "web");
    CHECK(find(catalog, "bee")->library == other.path() + "/bee.so");
    CHECK(find(catalog, "fly") == nullptr);
    CHECK(catalog.directories == std::vector<std::string>{one.path(), other.path()});
}

TEST_CASE("of modules with one id, the folder searched first wins", "[unit]") {
    ManifestFolder one;
    ManifestFolder other;
    one.add("web", "table = \"web\"");
    other.add("web", "table = \"web\"");
    const Catalog catalog = read_catalog({one.path(), other.path()});
    CHECK(catalog.faults.empty());
    CHECK(catalog.manifests.size() == 1);
    CHECK(find(catalog, "web")->path == one.path() + "/web.toml");
}

TEST_CASE("two modules that answer to one table are a fault, and so is one that answers to the scene's own",
          "[unit]") {
    ManifestFolder one;
    one.add("breeze", "table = \"wind\"");
    one.add("stage", "table = \"scene\"");
    one.add("wind", "table = \"wind\"");
    const Catalog catalog = read_catalog({one.path()});
    REQUIRE(catalog.faults.size() == 2);
    CHECK(to_string(catalog.faults[0]) ==
          one.path() +
              "/stage.toml: another module answers to [scene] already; expected one module for each "
              "table; remove one of the two, or search fewer folders");
    CHECK(catalog.faults[1].where.file == one.path() + "/wind.toml");
    CHECK(catalog.manifests.size() == 1);
}

TEST_CASE("a folder that cannot be searched is a fault", "[unit]") {
    const Folder other;
    other.write("file", "text");
    for (const std::string& place : {other.path("nowhere"), other.path("file")}) {
        const Catalog catalog = read_catalog({place});
        REQUIRE(catalog.faults.size() == 1);
        CHECK(to_string(catalog.faults.front()).rfind(place + ": modules cannot be searched here: ", 0) == 0);
    }
}

TEST_CASE("a manifest that is no file is a fault, and is not read", "[extreme]") {
    const Folder other;
    REQUIRE(::mkfifo(other.path("pipe.toml").c_str(), 0600) == 0);
    const Catalog catalog = read_catalog({other.path()});
    REQUIRE(catalog.faults.size() == 1);
    CHECK(to_string(catalog.faults.front()).find("this manifest cannot be read") != std::string::npos);
}

TEST_CASE("a folder that is named twice, however spelled, is searched once", "[unit]") {
    ManifestFolder one;
    const Folder other;
    one.add("web", "");
    std::filesystem::create_directory_symlink(one.path(), other.path("link"));
    const Catalog catalog = read_catalog({one.path(), one.path() + "/.", one.path(), other.path("link")});
    CHECK(catalog.faults.empty());
    CHECK(catalog.manifests.size() == 1);
}

TEST_CASE("folders asked for come first, then the environment's, then the program's own", "[unit]") {
    REQUIRE(::setenv("ORBWEAVER_MODULES", "/b::/c", 1) == 0);
    const auto directories = module_directories({"/a"});
    ::unsetenv("ORBWEAVER_MODULES");
    REQUIRE(directories.size() == 4);
    CHECK(directories[0] == "/a");
    CHECK(directories[1] == "/b");
    CHECK(directories[2] == "/c");
    CHECK_THAT(directories[3], Catch::EndsWith("/lib/orbweaver/modules"));
    CHECK(module_directories({}).size() == 1);
}

TEST_CASE("assets are looked for beside the scene first, and only in folders that are there", "[unit]") {
    const Folder folder;
    const auto directories = asset_directories(folder.path());
    REQUIRE(directories.size() >= 2);
    CHECK(directories[0] == folder.path());
    for (const std::string& each : directories) CHECK(std::filesystem::is_directory(each));
    CHECK(asset_directories("/nowhere/at/all").size() < directories.size());
}
