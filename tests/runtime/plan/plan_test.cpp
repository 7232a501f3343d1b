#include "plan/plan.hpp"

#include <catch2/catch.hpp>

#include "output/loaded_libraries.hpp"
#include "support/manifests.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

using Texts = std::vector<std::string>;

/// A small world: webs that threads are seen of, wind, a view with two canvases, a recorder, workers.
ManifestFolder world() {
    ManifestFolder folder;
    folder.add("web",
               "table = \"web\"\nseveral = true\nprovides = [\"threads/1\"]\nuses = [\"wind_field/1\", "
               "\"workers/1\"]\nphases = [\"integrate\"]");
    folder.add("wind", "table = \"wind\"\nprovides = [\"wind_field/1\"]\nphases = [\"sense\"]");
    folder.add("view",
               "table = \"view\"\nwhen = \"pictures\"\nprovides = [\"picture_source/1\"]\nneeds = "
               "[\"canvas/1\"]\ncollects = [\"threads/1\"]\nphases = [\"present\"]");
    folder.add("canvas_far", "when = \"offscreen\"\nprovides = [\"canvas/1\"]\nlibraries = [\"Far\"]");
    folder.add("canvas_near",
               "when = \"window\"\nprovides = [\"canvas/1\"]\nlibraries = [\"Near\", \"Nearer\"]");
    folder.add("film", "when = \"recording\"\nneeds = [\"picture_source/1\"]\nphases = [\"present\"]");
    folder.add("workers", "when = \"threads\"\nprovides = [\"workers/1\"]");
    return folder;
}

Request recording() {
    Request request;
    request.frames_directory = "out";
    return request;
}

}  // namespace

TEST_CASE("a plan loads what the scene asks for and names the reason of everything", "[unit]") {
    const ManifestFolder folder = world();
    const Planned planned(folder.catalog(), "[web]\n[wind]\n[view]\n");
    CHECK(planned.faults() == Texts{});
    CHECK(planned.loaded() == Texts{"wind: the scene has [wind]", "web: the scene has [web]"});
    CHECK(planned.left_out() == Texts{"canvas_far: no picture is drawn off-screen",
                                      "canvas_near: nobody asked for a window (--window)",
                                      "film: nobody asked for frames or a video (--frames, --video)",
                                      "view: nobody asked for pictures (--frames, --video or --window)",
                                      "workers: one thread was asked for (--threads)"});
}

TEST_CASE("a request draws in the modules that serve it", "[unit]") {
    const ManifestFolder folder = world();
    CHECK(Planned(folder.catalog(), "[web]\n[view]\n", recording()).loaded() ==
          Texts{"canvas_far: view needs canvas/1", "web: the scene has [web]", "view: the scene has [view]",
                "film: frames or a video were asked for"});

    Request window;
    window.window = true;
    const Planned shown(folder.catalog(), "[view]\n", window);
    CHECK(shown.loaded() == Texts{"canvas_near: view needs canvas/1", "view: the scene has [view]"});
    CHECK(shown.left_out() == Texts{"canvas_far: no picture is drawn off-screen",
                                    "film: nobody asked for frames or a video (--frames, --video)",
                                    "web: the scene has no [web]", "wind: the scene has no [wind]",
                                    "workers: one thread was asked for (--threads)"});

    Request threads;
    threads.threads = 2;
    CHECK(Planned(folder.catalog(), "[web]\n", threads).loaded() ==
          Texts{"workers: web uses workers/1", "web: the scene has [web]"});
    CHECK(Planned(folder.catalog(), "[wind]\n", threads).left_out().back() ==
          "workers: nothing in this plan needs it");
}

TEST_CASE("providers come before consumers, ties by name, whatever the scene's order", "[unit]") {
    ManifestFolder folder;
    folder.add("a", "table = \"a\"\nneeds = [\"z/1\"]");
    folder.add("b", "table = \"b\"\nseveral = true");
    folder.add("c", "table = \"c\"\ncollects = [\"a/1\"]");
    folder.add("z", "table = \"z\"\nprovides = [\"z/1\", \"a/1\"]");
    const auto order = [&](const char* scene) {
        Texts names;
        const Planned planned(folder.catalog(), scene);
        for (const PlannedModule& module : planned.plan.modules) names.push_back(module.instance);
        return names;
    };
    const Texts expected{"b", "b.2", "z", "a", "c"};
    CHECK(order("[a]\n[[b]]\n[[b]]\n[c]\n[z]\n") == expected);
    CHECK(order("[z]\n[c]\n[[b]]\n[[b]]\n[a]\n") == expected);
}

TEST_CASE("a window is asked for in vain where nothing draws into one", "[unit]") {
    const ManifestFolder folder = world();
    Request window;
    window.window = true;
    CHECK(Planned(folder.catalog(), "[view]\n", window).faults() == Texts{});
    CHECK(Planned(folder.catalog(), "[web]\n", window).faults() ==
          Texts{"scene.toml: a window was asked for (--window), and nothing in this plan draws into one; add "
                "[view] to the scene"});
}

TEST_CASE("several tables of one name become instances by number", "[unit]") {
    const ManifestFolder folder = world();
    const Planned planned(folder.catalog(), "[[web]]\n[[web]]\n[[web]]\n");
    CHECK(planned.loaded() == Texts{"web: the scene has [web]", "web.2: the scene has [web], number 2",
                                    "web.3: the scene has [web], number 3"});
    CHECK(Planned(folder.catalog(), "[[wind]]\n").faults() == Texts{});
    CHECK(Planned(folder.catalog(), "[[wind]]\n[[wind]]\n").faults().front() ==
          "scene.toml:1:3: there are 2 [[wind]]; expected one [wind]");
    CHECK(Planned(folder.catalog(), "web = 3\n").faults() ==
          Texts{"scene.toml:1:7: this is 3; expected a table"});
    CHECK(Planned(folder.catalog(), "web = []\n").faults() ==
          Texts{"scene.toml:1:1: 'web' is an empty array; expected a table"});
    CHECK(Planned(folder.catalog(), "web = [3]\n").faults() ==
          Texts{"scene.toml:1:8: this is 3; expected a table"});
}

TEST_CASE("a table that no module answers to is named with its place, the nearest name and the folders",
          "[unit]") {
    const ManifestFolder folder = world();
    CHECK(Planned(folder.catalog(), "[wnid]\n").faults() ==
          Texts{"scene.toml:1:2: no module answers to [wnid]; expected one of scene, view, web or wind; did "
                "you mean "
                "[wind]? modules were searched in " +
                folder.path()});
    const ManifestFolder empty;
    CHECK(Planned(read_catalog({folder.path(), empty.path()}), "[helicopter]\n").faults() ==
          Texts{"scene.toml:1:2: no module answers to [helicopter]; expected one of scene, view, web or wind; "
                "modules "
                "were searched in " +
                folder.path() + ", " + empty.path()});
}

TEST_CASE("a need that nothing meets names who could meet it", "[unit]") {
    ManifestFolder folder;
    folder.add("eater", "table = \"eater\"\nneeds = [\"food/1\", \"salt/1\", \"light/1\"]");
    folder.add("cook", "table = \"kitchen\"\nprovides = [\"food/1\"]");
    folder.add("lamp", "when = \"window\"\nprovides = [\"light/1\"]");
    CHECK(
        Planned(folder.catalog(), "[eater]\n").faults() ==
        Texts{"scene.toml: 'eater' needs food/1, which nothing in this plan provides; 'cook' provides it: add "
              "[kitchen] to the scene",
              "scene.toml: 'eater' needs salt/1, which nothing in this plan provides; no module in " +
                  folder.path() + " provides it",
              "scene.toml: 'eater' needs light/1, which nothing in this plan provides; 'lamp' provides it, but "
              "nobody asked for a window (--window)"});
}

TEST_CASE("two providers of what must have one are named", "[unit]") {
    ManifestFolder folder;
    folder.add("vane", "table = \"vane\"\nuses = [\"wind_field/1\"]");
    folder.add("gale", "table = \"gale\"\nprovides = [\"wind_field/1\"]");
    folder.add("breeze", "table = \"breeze\"\nprovides = [\"wind_field/1\"]");
    const Planned planned(folder.catalog(), "[vane]\n[gale]\n[breeze]\n");
    CHECK(planned.faults() ==
          Texts{"scene.toml: 'vane' takes wind_field/1 from one module, and gale and breeze provide "
                "it; expected one provider; leave one of them out"});
}

TEST_CASE("modules that need each other in a circle are named", "[unit]") {
    ManifestFolder folder;
    folder.add("hen", "table = \"hen\"\nprovides = [\"egg/1\"]\nneeds = [\"hen/1\"]");
    folder.add("egg", "table = \"egg\"\nprovides = [\"hen/1\"]\nneeds = [\"egg/1\"]");
    folder.add("farm", "table = \"farm\"");
    CHECK(
        Planned(folder.catalog(), "[hen]\n[egg]\n[farm]\n").faults() ==
        Texts{"scene.toml: egg and hen need each other in a circle; expected providers that come before their "
              "consumers; leave one of them out"});
}

TEST_CASE("all faults are found at once", "[unit]") {
    ManifestFolder folder = world();
    folder.add("eater",
               "table = \"eater\"\nneeds = [\"food/1\"]\n[options.size]\ntype = \"number\"\nunit = "
               "\"m\"\nmeaning = \"how large\"");
    folder.add("broken", "phases = [\"dance\"]");
    const Texts faults =
        Planned(folder.catalog(), "[scene]\nstep = \"1 kg\"\n[eater]\nsize = nan\nsise = 1\n[webb]\n").faults();
    REQUIRE(faults.size() == 6);
    CHECK_THAT(faults[0], Catch::Contains("there is no phase 'dance'"));
    CHECK_THAT(faults[1],
               Catch::StartsWith("scene.toml:2:8: 'step' is \"1 kg\", which is not a quantity of s"));
    CHECK_THAT(faults[2], Catch::StartsWith("scene.toml:4:8: 'size' is nan"));
    CHECK_THAT(faults[3], Catch::StartsWith("scene.toml:5:1: there is no option 'sise'"));
    CHECK_THAT(faults[4], Catch::StartsWith("scene.toml:6:2: no module answers to [webb]"));
    CHECK_THAT(faults[5], Catch::StartsWith("scene.toml: 'eater' needs food/1"));
}

TEST_CASE("planning is a pure function that opens no library", "[unit]") {
    const ManifestFolder folder = world();
    const auto before = loaded_libraries();
    const Planned first(folder.catalog(), "[web]\n[wind]\n[view]\n", recording());
    const Planned second(folder.catalog(), "[web]\n[wind]\n[view]\n", recording());
    CHECK(first.faults() == Texts{});
    CHECK(plan_json(first.plan) == plan_json(second.plan));
    CHECK(plan_text(first.plan) == plan_text(second.plan));
    CHECK(loaded_libraries() == before);
}

TEST_CASE("more pictures a second than frames are a fault of the plan", "[unit]") {
    const ManifestFolder folder = world();
    Request request = recording();
    const auto faults = [&](double rate) {
        request.frames_per_second = rate;
        return Planned(folder.catalog(), "[scene]\nstep = \"1/60 s\"\n[web]\n[wind]\n[view]\n", request)
            .faults();
    };
    CHECK(faults(0) == Texts{});
    CHECK(faults(60) == Texts{});
    CHECK(faults(60.5) ==
          Texts{"--fps: 60.5 pictures a second of 60 frames a second; expected at most 60; leave it "
                "out, or make --step smaller"});
}

TEST_CASE("what the request collects brings its providers, those that have what they need", "[unit]") {
    ManifestFolder folder;
    folder.add("surface", "table = \"surface\"\nprovides = [\"surface/1\", \"ways/1\"]");
    folder.add("clearance", "provides = [\"clearance/1\", \"ways/1\"]\nneeds = [\"surface/1\"]");
    folder.add("other", "provides = [\"ways/2\"]");
    Request request;
    request.collects = {"ways/1"};
    const Planned planned(folder.catalog(), "[surface]\n", request);
    CHECK(planned.faults() == Texts{});
    CHECK(planned.loaded() ==
          Texts{"surface: the scene has [surface]", "clearance: ways/1 is asked of all that provide it"});
    CHECK(Planned(folder.catalog(), "[surface]\n").loaded() == Texts{"surface: the scene has [surface]"});
    CHECK(Planned(folder.catalog(), "[scene]\n", request).loaded() == Texts{});
}
