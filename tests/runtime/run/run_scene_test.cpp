#include "run/run_scene.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "support/file_size_limit.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;
using nlohmann::json;

namespace {

Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& fixtures) {
    arguments.insert(arguments.begin(), "run");
    for (const std::string& name : fixtures) {
        arguments.push_back("--modules");
        arguments.push_back(fixture(name));
    }
    return run_program(arguments);
}

constexpr const char* kScene = "[scene]\nduration = 1\nstep = 0.1\nseed = 7\n[counter]\n";

}  // namespace

TEST_CASE("a run leaves every file that was asked for, and no other", "[scene]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", kScene);
    const Outcome outcome =
        run({scene, "--quiet", "--trajectory", folder.path("t"), "--telemetry", folder.path("c.csv"),
             "--report", folder.path("r.json"), "--save-state", folder.path("state")},
            {"counter"});
    CHECK(outcome.code == 0);
    CHECK(outcome.out == "");
    CHECK(folder.names() == std::vector<std::string>{"c.csv", "r.json", "scene.toml", "state", "t"});
    const json report = json::parse(read_file(folder.path("r.json")));
    CHECK(report["outcome"] == "done");
    CHECK(report["frames"] == 10);
    CHECK(report["simulated_s"].get<double>() == Approx(1));
    CHECK(report["seed"] == 7);
}

TEST_CASE("a run in two parts gives the hash of the run that never stopped", "[scene]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", kScene);
    const auto hash = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), scene);
        arguments.insert(arguments.end(), {"--quiet", "--report", folder.path("r.json")});
        CHECK(run(arguments, {"counter"}).code == 0);
        return json::parse(read_file(folder.path("r.json")))["state_hash"];
    };
    const json whole = hash({});
    CHECK(hash({}) == whole);
    CHECK(hash({"--seed", "8"}) != whole);
    CHECK(hash({"--duration", "0.4", "--save-state", folder.path("state")}) != whole);
    CHECK(hash({"--restore-state", folder.path("state")}) == whole);
}

TEST_CASE("a run that diverges keeps its last good state and says so with code 4", "[scene]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", "[scene]\nstep = 0.1\n[diverges]\n");
    const Outcome outcome = run({scene, "--quiet", "--report", folder.path("r.json"), "--save-state",
                                 folder.path("state"), "--telemetry", folder.path("c.csv")},
                                {"diverges"});
    const std::string sentence =
        "module 'diverges' failed in frame 3, phase integrate: particle 7 is at nan m; take a smaller step";
    CHECK(outcome.code == 4);
    CHECK_THAT(outcome.err, Catch::StartsWith("error: " + sentence + "\n"));
    const json report = json::parse(read_file(folder.path("r.json")));
    CHECK(report["outcome"] == "diverged");
    CHECK(report["message"] == sentence);
    CHECK(report["frames"] == 3);
    const OpenedScene opened("[scene]\nstep = 0.1\n[diverges]\n", {"diverges"});
    opened.run(3);
    CHECK(report["state_hash"] == fmt::format("{:016x}", opened.session->state_hash()));
    const std::string csv = read_file(folder.path("c.csv"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);  // a header, and the states 0 to 3
}

TEST_CASE("an interrupted run completes its files and says that it was stopped", "[scene]") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const Folder folder;
        const std::string scene = folder.write(
            "scene.toml", "[scene]\nduration = 100\nstep = 0.01\n[counter]\nnested.delay = 0.005\n");
        Program program({"run", scene, "--quiet", "--modules", fixture("counter"), "--trajectory",
                         folder.path("t"), "--telemetry", folder.path("c.csv"), "--report",
                         folder.path("r.json")});
        while (!std::filesystem::exists(folder.path(".c.part0.csv")))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        program.send(signal);
        const Outcome outcome = program.wait();
        CHECK(outcome.code == 0);
        CHECK(folder.names() == std::vector<std::string>{"c.csv", "r.json", "scene.toml", "t"});
        const json report = json::parse(read_file(folder.path("r.json")));
        CHECK(report["outcome"] == "stopped");
        const auto frames = report["frames"].get<std::uint64_t>();
        CHECK(frames > 0);
        CHECK(frames < 10000);
        const json trajectory = json::parse(read_file(folder.path("t/trajectory.json")));
        CHECK(trajectory["quantities"]["time"]["shape"][0] == frames + 1);
    }
}

TEST_CASE("a state that does not fit ends the run with code 3 before it begins", "[extreme]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", kScene);
    const std::string state = folder.write("state", "no state");
    const Outcome outcome = run({scene, "--quiet", "--restore-state", state}, {"counter"});
    CHECK(outcome.code == 3);
    CHECK(outcome.err.find(state + ": this is not a snapshot; expected a file that --save-state wrote") !=
          std::string::npos);
}

TEST_CASE("an output that cannot be written ends the run in words and leaves nothing of it", "[extreme]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", kScene);
    folder.write("file", "x");
    for (const char* option : {"--trajectory", "--telemetry", "--report", "--save-state"}) {
        CAPTURE(option);
        const std::string below = folder.path("file/out");
        const Outcome outcome = run({scene, "--quiet", option, below}, {"counter"});
        CHECK(outcome.code == 1);
        CHECK(outcome.err.find("error: " + below) != std::string::npos);
        CHECK(folder.names() == std::vector<std::string>{"file", "scene.toml"});
    }
}

TEST_CASE("a disk that fills while a run goes ends it with code 5 and no half-written file", "[extreme]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", "[scene]\nduration = 100\nstep = 0.1\n[counter]\n");
    const std::pair<const char*, const char*> outputs[] = {{"--trajectory", "t"}, {"--telemetry", "c.csv"}};
    for (const auto& [option, name] : outputs) {
        CAPTURE(option);
        const Outcome outcome = [&] {
            const FileSizeLimit limit(16384);  // a child inherits it, and that its signal is ignored
            return run({scene, "--quiet", option, folder.path(name), "--report", folder.path("r.json")},
                       {"counter"});
        }();
        CHECK(outcome.code == 5);
        CHECK_THAT(outcome.err,
                   Catch::Contains(": cannot be written: File too large; make room and run again"));
        CHECK(json::parse(read_file(folder.path("r.json")))["outcome"] == "limit");
        std::filesystem::remove(folder.path("r.json"));
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
            CHECK((entry.is_directory() || entry.path().filename() == "scene.toml"));
    }
}

TEST_CASE("whatever fails while a run is closed, everything else is closed", "[extreme]") {
    const Folder folder;
    for (const char* what : {"fault", "exception", "memory", "integer"}) {
        CAPTURE(what);
        const std::string scene = folder.write(
            "scene.toml", fmt::format("[scene]\nduration = 1\nstep = 0.1\n[counter]\n[thrower]\nwhere = "
                                      "\"finish\"\nwhat = \"{}\"\n",
                                      what));
        const Outcome outcome =
            run({scene, "--trajectory", folder.path("t"), "--telemetry", folder.path("c.csv"), "--report",
                 folder.path("r.json"), "--save-state", folder.path("state")},
                {"counter", "thrower"});
        CHECK(outcome.code != 0);
        CHECK(folder.names() == std::vector<std::string>{"c.csv", "r.json", "scene.toml", "state", "t"});
        const json report = json::parse(read_file(folder.path("r.json")));
        CHECK(report["frames"] == 10);
        CHECK(report["modules"].size() == 2);
        for (const char* name : {"c.csv", "r.json", "state", "t"})
            std::filesystem::remove_all(folder.path(name));
    }
}

TEST_CASE("a report that cannot be written does not hide why the run ended", "[extreme]") {
    const Folder folder;
    const std::string scene = folder.write(
        "scene.toml", "[scene]\nname = \"" + std::string(8000, 'n') + "\"\nstep = 0.1\n[diverges]\n");
    const Outcome outcome = [&] {
        const FileSizeLimit limit(4096);
        return run({scene, "--quiet", "--report", folder.path("r.json")}, {"diverges"});
    }();
    CHECK(outcome.code == 4);
    CHECK_THAT(outcome.err, Catch::Contains("r.json: cannot be written: File too large"));
    CHECK(folder.names() == std::vector<std::string>{"scene.toml"});
}

TEST_CASE("every output is tried before the first frame, and its folders are made", "[extreme]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", kScene);
    folder.write("file", "x");
    for (const char* option : {"--report", "--save-state"}) {
        CAPTURE(option);
        const Outcome outcome = run({scene, option, folder.path("file/out")}, {"counter"});
        CHECK(outcome.code == 1);
        CHECK(outcome.err.find("frames") == std::string::npos);
        CHECK(outcome.out == "");  // no report of a run that was none
        CHECK(
            run({scene, "--quiet", option, folder.path(std::string("deep/of/") + option)}, {"counter"}).code ==
            0);
        CHECK(std::filesystem::is_regular_file(folder.path(std::string("deep/of/") + option)));
    }
}

TEST_CASE("a report is written of a scene that is invalid, too", "[extreme]") {
    const Folder folder;
    const std::string report = folder.path("r.json");
    for (const char* text : {"[counter]\nstart = 1001\n", "[counter\n"}) {
        CAPTURE(text);
        const std::string scene = folder.write("scene.toml", text);
        const Outcome outcome = run({scene, "--report", report}, {"counter"});
        CHECK(outcome.code == 3);
        CHECK(outcome.out == "");
        const json said = json::parse(read_file(report));
        CHECK(said["outcome"] == "invalid");
        CHECK_THAT(said["message"].get<std::string>(), Catch::StartsWith(scene + ":"));
        std::filesystem::remove(report);
    }
}

TEST_CASE("the last good state of a run that went on from another is of the scene's time", "[scene]") {
    const Folder folder;
    const std::string scene = folder.write("scene.toml", "[scene]\nstep = 0.1\n[diverges]\n");
    const std::string state = folder.path("state");
    REQUIRE(run({scene, "--duration", "0.2", "--save-state", state}, {"diverges"}).code == 0);
    const Outcome outcome = run({scene, "--restore-state", state, "--save-state", state}, {"diverges"});
    CHECK(outcome.code == 4);
    CHECK_THAT(outcome.err, Catch::Contains("the last good state is of time 0.3 s, in " + state));
}

TEST_CASE("a second signal ends a run within its frame, and leaves nothing under a final name", "[extreme]") {
    const Folder folder;
    const std::string scene =
        folder.write("scene.toml", "[scene]\nduration = 1\nstep = 0.1\n[counter]\nnested.delay = 60\n");
    Program program(
        {"run", scene, "--quiet", "--modules", fixture("counter"), "--telemetry", folder.path("c.csv")});
    while (!std::filesystem::exists(folder.path(".c.part0.csv")))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    program.send(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    program.send(SIGINT);
    CHECK(program.wait().code == -SIGINT);
    CHECK_FALSE(std::filesystem::exists(folder.path("c.csv")));
}

TEST_CASE("checking a scene runs nothing and says what it found", "[scene]") {
    const Folder folder;
    const std::string good = folder.write("good.toml", kScene);
    const Outcome outcome = run_program({"check", good, "--modules", fixture("counter")});
    CHECK(outcome.code == 0);
    CHECK(outcome.out == good + ": no fault found\n");

    const std::string bad = folder.write("bad.toml", "[counter]\nmode = \"upp\"\nstart = 1001\n");
    const Outcome faults = run_program({"check", bad, "--modules", fixture("counter")});
    CHECK(faults.code == 3);
    CHECK(faults.err == bad + ":2:8: 'mode' is \"upp\"; expected one of up or down; did you mean \"up\"?\n" +
                            bad + ":3:9: 'start' is 1001; expected an integer at least 0 and at most 1000\n" +
                            "2 faults; nothing was run\n");
    CHECK(run({bad}, {"counter"}).code == 3);
}
