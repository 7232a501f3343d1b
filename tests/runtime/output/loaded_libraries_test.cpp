#include "output/loaded_libraries.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "load/loader.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

using Paths = std::set<std::string>;

/// The shared objects that the kernel says are mapped executable, by real path; the program left out.
Paths mapped() {
    Paths paths;
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    std::stringstream maps(read_file("/proc/self/maps"));
    for (std::string line; std::getline(maps, line);) {
        const auto slash = line.find('/');
        if (slash == std::string::npos || line.find(" r-xp ") == std::string::npos) continue;
        if (line.substr(slash) != program) paths.insert(line.substr(slash));
    }
    return paths;
}

Paths real(const std::vector<std::string>& names) {
    Paths paths;
    for (const std::string& name : names) paths.insert(std::filesystem::canonical(name).string());
    return paths;
}

}  // namespace

TEST_CASE("the libraries reported are those that the kernel has mapped", "[unit]") {
    const auto before = loaded_libraries();
    CHECK(std::is_sorted(before.begin(), before.end()));
    CHECK(real(before) == mapped());
    const OpenedScene opened("[counter]\n", {"counter"});
    const auto after = loaded_libraries();
    CHECK(real(after) == mapped());
    CHECK(std::count(after.begin(), after.end(), fixture("counter") + "/counter.so") == 1);
}

TEST_CASE("a module found by a relative path is reported too, in full", "[unit]") {
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(ORBWEAVER_FIXTURES);
    for (const char* folder : {"diverges", "./diverges", "counter/../diverges"}) {
        CAPTURE(folder);
        const Catalog catalog = read_catalog({folder});
        REQUIRE(catalog.manifests.size() == 1);
        const LoadedModule module(catalog.manifests.front());
        const auto all = loaded_libraries();
        CHECK(std::count(all.begin(), all.end(), fixture("diverges") + "/diverges.so") == 1);
    }
    std::filesystem::current_path(before);
}
