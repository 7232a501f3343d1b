#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "scratch.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

using Names = std::set<std::string>;

/// The shared objects in this process's own memory map, by file name up to ".so".
Names mapped_libraries() {
    Names names;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const auto slash = line.rfind('/');
        if (slash == std::string::npos) continue;
        const std::string name = line.substr(slash + 1);
        const auto end = name.find(".so");
        if (end != std::string::npos) names.insert(name.substr(0, end));
    }
    return names;
}

/// What a child process maps beyond what it began with, while `body` holds a session open.
Names newly_mapped(const std::function<void(const std::function<void()>&)>& body) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::close(ends[0]);
        const Names before = mapped_libraries();
        int code = 1;
        try {
            body([&] {
                std::string list;
                for (const std::string& name : mapped_libraries())
                    if (before.count(name) == 0) list += name + "\n";
                code = ::write(ends[1], list.data(), list.size()) == static_cast<ssize_t>(list.size()) ? 0 : 1;
            });
        } catch (const std::exception& error) {
            const std::string text = std::string("failed: ") + error.what();
            code = ::write(ends[1], text.data(), text.size()) > 0 ? 1 : 2;
        }
        ::_exit(code);
    }
    ::close(ends[1]);
    std::string text;
    char buffer[4096];
    for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(n));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    INFO(text);
    REQUIRE(WIFEXITED(status));
    REQUIRE(WEXITSTATUS(status) == 0);
    Names names;
    std::stringstream lines(text);
    for (std::string line; std::getline(lines, line);) names.insert(line);
    return names;
}

Names mapped_by(const std::string& scene, const Request& request) {
    return newly_mapped([&](const std::function<void()>& report) {
        OpenScene open = open_scene_file(scene, request);
        open.session->step();
        report();
    });
}

}  // namespace

TEST_CASE("headless, a scene maps its own physics and nothing else", "[scene]") {
    const std::map<std::string, Names> expected = {
        {"cliff", {"surface", "web", "wind"}},
        {"chase", {"spider", "surface"}},
        {"crowd", {"spider", "surface"}},
        {"glass", {"spider", "surface"}},
        {"huntsman_cliff", {"spider", "surface"}},
        {"geodesics", {"surface"}},
        {"huntsman_cube", {"spider", "surface"}},
        {"huntsman_hill", {"spider", "surface"}},
        {"huntsman_room", {"spider", "surface"}},
        {"path", {"spider", "surface"}},
        {"some_pig", {"inscription", "web", "wind"}},
        {"wall_following", {"spider", "surface"}},
        {"meadow", {"web", "wind"}},
        {"thesis_web", {"web"}},
        {"strand", {"web"}},
        {"network", {"web"}},
        {"steady_wind", {"web", "wind"}},
        {"real_silk", {"web", "wind"}},
        {"stiff_strand", {"web"}},
        {"viscoelastic_silk", {"web", "wind"}},
        {"worm", {"crawler", "surface"}},
        {"snake", {"crawler", "surface"}},
        {"sidewinder", {"crawler", "surface"}},
        {"caterpillar", {"crawler", "surface"}},
        {"grip", {"crawler", "surface"}},
        {"worm_cliff", {"crawler"}},
        {"caterpillar_branch", {"crawler", "surface"}},
        {"snake_hill", {"crawler", "surface"}},
        {"garden", {"crawler", "spider", "surface", "web", "wind"}},
    };
    for (const std::string& name : shipped_scenes()) {
        CAPTURE(name);
        REQUIRE(expected.count(name) == 1);
        CHECK(mapped_by(scene_path(name), {}) == expected.at(name));
    }
}

TEST_CASE("a flat floor maps its module alone: no mesh, no tree, no FCL", "[scene]") {
    const test::Scratch folder;
    const std::string scene = folder.write("floor.toml", "[surface]\nfloor = \"4 m\"\n");
    CHECK(mapped_by(scene, {}) == Names{"surface"});
    const OpenScene open = open_scene_file(scene);
    CHECK_THAT(plan_text(open.planned.plan),
               Catch::Contains("a flat floor: no mesh is mapped and no tree is built") &&
                   Catch::Contains("nothing in this plan needs it [fcl, ccd, octomap]"));
}

TEST_CASE("threads bring oneTBB, and only when asked for", "[scene]") {
    Request two;
    two.threads = 2;
    CHECK(mapped_by(scene_path("meadow"), two) == Names{"web", "wind", "workers", "libtbb", "libtbbmalloc"});
}

TEST_CASE("pictures bring one software rasterizer and no window library", "[scene]") {
    Request pictures;
    pictures.pictures = true;
    const Names names = mapped_by(scene_path("meadow"), pictures);
    for (const char* wanted : {"web", "wind", "view", "canvas_osmesa", "libOSMesa", "libglapi"}) {
        CAPTURE(wanted);
        CHECK(names.count(wanted) == 1);
    }
    for (const char* unwanted : {"canvas_sdl", "film", "libGL", "libEGL", "libX11"}) {
        CAPTURE(unwanted);
        CHECK(names.count(unwanted) == 0);
    }
    for (const std::string& name : names) CHECK(name.find("SDL") == std::string::npos);
}

TEST_CASE("the plan names every module as loaded or left out, once", "[scene]") {
    for (const std::string& name : shipped_scenes()) {
        CAPTURE(name);
        const OpenScene scene = open_scene(name);
        std::multiset<std::string> ids;
        for (const PlannedModule& module : scene.planned.plan.modules) ids.insert(module.manifest->id);
        for (const LeftOut& each : scene.planned.plan.left_out) {
            ids.insert(each.manifest->id);
            CHECK_FALSE(each.reason.empty());
        }
        for (const Manifest& manifest : scene.planned.catalog.manifests) CHECK(ids.count(manifest.id) >= 1);
    }
}
