#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

using namespace orbweaver::test;

namespace {

struct Scene {
    Folder folder;
    std::string path = folder.write("scene.toml", "[scene]\nduration = 0.2\nstep = 0.1\n[counter]\n");
    std::string modules = fixture("counter");
};

}  // namespace

TEST_CASE("asking for help or the version is no error, and help names every command and option", "[scene]") {
    for (const char* flag : {"--help", "-h"}) {
        const Outcome outcome = run_program({flag});
        CHECK(outcome.code == 0);
        for (const char* word : {"run", "plan", "check", "modules"})
            CHECK_THAT(outcome.out, Catch::Contains(word));
    }
    CHECK(run_program({"--version"}).code == 0);
    const Outcome run = run_program({"run", "--help"});
    CHECK(run.code == 0);
    for (const char* option :
         {"SCENE", "--headless", "--window", "--duration", "--step", "--seed", "--threads", "--set", "--frames",
          "--video", "--size", "--fps", "--trajectory", "--telemetry", "--report", "--quiet", "--modules"}) {
        CAPTURE(option);
        CHECK_THAT(run.out, Catch::Contains(option));
    }
}

TEST_CASE("a command line that means nothing ends with code 2 and says why", "[extreme]") {
    const Scene scene;
    struct Case {
        std::vector<std::string> arguments;
        const char* sentence;
    };
    const Case cases[] = {
        {{}, "A subcommand is required"},
        {{"fly"}, "A subcommand is required"},
        {{"run"}, "SCENE is required"},
        {{"run", scene.path, "--fast"}, "--fast"},
        {{"run", scene.path, "another.toml"}, "another.toml"},
        {{"run", scene.path, "--window", "--headless"}, "--headless"},
        {{"run", scene.path, "--threads", "0"}, "--threads"},
        {{"run", scene.path, "--threads", "many"}, "--threads"},
        {{"run", scene.path, "--fps", "0"},
         "--fps: '0' is not a rate; expected 0.001 to 1000000 pictures a second"},
        {{"run", scene.path, "--fps", "-1"}, "--fps"},
        {{"run", scene.path, "--size", "big"},
         "--size: 'big' is not a size; expected WxH with 1 to 16384 pixels each, such as 1280x720"},
        {{"run", scene.path, "--size", "10"}, "'10' is not a size"},
        {{"run", scene.path, "--size", "10x"}, "'10x' is not a size"},
        {{"run", scene.path, "--size", "0x10"}, "'0x10' is not a size"},
        {{"run", scene.path, "--size", "-5x10"}, "'-5x10' is not a size"},
        {{"run", scene.path, "--size", "10x10px"}, "'10x10px' is not a size"},
        {{"run", scene.path, "--size", "20000x10"}, "'20000x10' is not a size"},
        {{"run", scene.path, "--size", "99999999999999999999x10"}, "is not a size"},
        {{"run", scene.path, "--duration", "soon"},
         "--duration: 'soon' is not a time; expected seconds or a text such as \"20 s\""},
        {{"run", scene.path, "--duration", "3 parsec"}, "'3 parsec' is not a time"},
        {{"run", scene.path, "--step", "1e999"}, "--step: '1e999' is not a time"},
        {{"run", scene.path, "--size", " 12x 3"}, "' 12x 3' is not a size"},
        {{"run", scene.path, "--size", ""}, "'' is not a size"},
        {{"run", scene.path, "--duration", ""}, "--duration: '' is not a time"},
        {{"run", scene.path, "--seed", ""}, "--seed: '' is not a seed"},
        {{"run", scene.path, "--seed", "-1"}, "'-1' is not a seed; expected a whole number from 0 on"},
        {{"run", scene.path, "--fps", "nan"}, "--fps: 'nan' is not a rate"},
        {{"run", scene.path, "--fps", "inf"}, "--fps: 'inf' is not a rate"},
        {{"run", scene.path, "--set", "foo"}, "--set: 'foo' is not an override; expected path.to.key=value"},
        {{"check", scene.path, "--set", "=1"}, "'=1' is not an override"},
        {{"plan", scene.path, "--set", ".web=1"}, "'.web=1' is not an override"},
        {{"run", scene.path, "--telemetry", "out/a", "--report", "out/../out/a"},
         "--report: 'out/../out/a' is a file that --telemetry writes; name another"},
        {{"run", scene.path, "--telemetry", "d/time.npy", "--trajectory", "d"},
         "--telemetry: 'd/time.npy' is a file that --trajectory writes"},
        {{"run", scene.path, "--report", "d/trajectory.json", "--trajectory", "d/"},
         "--report: 'd/trajectory.json' is a file that --trajectory writes"},
        {{"check", scene.path, "--frames", "out"}, "--frames"},
        {{"modules", "a", "b"}, "b"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.sentence, c.arguments);
        const Outcome outcome = run_program(c.arguments);
        CHECK(outcome.code == 2);
        CHECK(outcome.out == "");
        CHECK_THAT(outcome.err, Catch::Contains(c.sentence));
    }
}

TEST_CASE("a time on the command line may have a unit, and one of another kind is refused by name", "[scene]") {
    const Scene scene;
    const auto frames = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"run", scene.path, "--quiet", "--modules", scene.modules,
                                             "--report", scene.folder.path("r.json")});
        REQUIRE(run_program(arguments).code == 0);
        return nlohmann::json::parse(read_file(scene.folder.path("r.json")))["frames"].get<int>();
    };
    CHECK(frames({}) == 2);
    CHECK(frames({"--duration", "0.5"}) == 5);
    CHECK(frames({"--duration", "1/2 s"}) == 5);
    CHECK(frames({"--duration", "300 ms", "--step", "100 ms"}) == 3);
    CHECK(frames({"--step", "1/60"}) == 12);
    CHECK(frames({"--set", "scene.duration=0.4"}) == 4);
    CHECK(frames({"--duration", "0"}) == 0);

    const Outcome outcome = run_program({"run", scene.path, "--modules", scene.modules, "--duration", "3 kg"});
    CHECK(outcome.code == 3);
    CHECK_THAT(outcome.err, Catch::Contains("--set scene.duration: 'duration' is \"3 kg\", which is not a "
                                            "quantity of s; expected a number of s"));
}

TEST_CASE("a scene that is not there, or is none, ends with code 3", "[extreme]") {
    const Scene scene;
    for (const char* command : {"run", "plan", "check"}) {
        CAPTURE(command);
        const std::string none = scene.folder.path("none.toml");
        const Outcome outcome = run_program({command, none});
        CHECK(outcome.code == 3);
        CHECK(outcome.out == "");
        CHECK(outcome.err ==
              "error: " + none + ": there is no such file; expected a TOML file; check the path\n");
        CHECK(run_program({command, scene.folder.path()}).code == 3);
        CHECK(run_program({command, scene.folder.write("bad.toml", "[web\n")}).code == 3);
        CHECK(run_program({command, scene.path, "--modules", scene.modules, "--set", "counter.start=x"}).code ==
              3);
    }
}

TEST_CASE("a scene beyond every limit ends with code 5, not with a crash", "[extreme]") {
    const Folder folder;
    std::string tables;
    for (int i = 0; i < 600000; ++i) tables += "[a.b.c.d.e.f.g.h]\n";
    std::string key;
    for (int i = 0; i < 500000; ++i) key += "a.";
    for (const std::string& text : {tables, key + "a = 1\n", std::string(400000, '[')}) {
        const Outcome outcome = run_program({"check", folder.write("scene.toml", text)});
        CHECK(outcome.code == 5);
        CHECK_THAT(outcome.err, Catch::StartsWith("error: " + folder.path("scene.toml")));
    }
}

TEST_CASE("a plan goes to standard output, for persons and for programs, and needs no library", "[scene]") {
    const Scene scene;
    const Outcome text = run_program({"plan", scene.path, "--modules", scene.modules});
    CHECK(text.code == 0);
    CHECK_THAT(text.out, Catch::Contains("counter          the scene has [counter]"));
    CHECK(text.err == "");

    const Folder manifest_alone;
    manifest_alone.write("counter.toml", read_file(scene.modules + "/counter.toml"));
    const Outcome json = run_program({"plan", scene.path, "--json", "--modules", manifest_alone.path()});
    CHECK(json.code == 0);
    const auto plan = nlohmann::json::parse(json.out);
    CHECK(plan["modules"][0]["name"] == "counter");
    CHECK(plan["faults"].empty());

    const Outcome faulty = run_program(
        {"plan", scene.path, "--json", "--modules", manifest_alone.path(), "--set", "counter.stride=nan"});
    CHECK(faulty.code == 3);
    CHECK(nlohmann::json::parse(faulty.out)["faults"][0]["file"] == "--set counter.stride");
}

TEST_CASE("a run speaks on standard error while it goes and reports on standard output", "[scene]") {
    const Scene scene;
    const Outcome outcome = run_program({"run", scene.path, "--modules", scene.modules});
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::StartsWith("scene: done, 2 frames, 0.2 s simulated in "));
    CHECK_THAT(outcome.err,
               Catch::Contains("info: counter: counts from 0\n") && Catch::Contains("scene 2/2 frames, "));
    const Outcome quiet = run_program({"run", scene.path, "--modules", scene.modules, "--quiet"});
    CHECK(quiet.out == "");
    CHECK(quiet.err.find("frames") == std::string::npos);
}

TEST_CASE("with its standard streams closed, what a program says stays out of its files", "[extreme]") {
    const Scene scene;
    const std::string report = scene.folder.path("r.json");
    const std::string command = std::string(ORBWEAVER_PROGRAM) + " run " + scene.path + " --modules " +
                                scene.modules + " --report " + report + " 0<&- >&- 2>&-";
    CHECK(std::system(command.c_str()) == 0);
    CHECK(nlohmann::json::parse(read_file(report))["outcome"] == "done");
}

TEST_CASE("results that do not reach standard output are said to be lost", "[extreme]") {
    const Scene scene;
    const std::string program = ORBWEAVER_PROGRAM;
    const auto code = [](const std::string& command) { return WEXITSTATUS(std::system(command.c_str())); };
    CHECK(code(program + " plan " + scene.path + " --modules " + scene.modules + " > /dev/full 2> " +
               scene.folder.path("err")) == 1);
    CHECK_THAT(read_file(scene.folder.path("err")),
               Catch::Contains("standard output: results were lost: No space left on device"));
    CHECK(code(program + " run " + scene.path + " --modules " + scene.modules + " 2> /dev/full > /dev/null") ==
          0);
}
