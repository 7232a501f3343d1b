#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "program.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

namespace {

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Hostile {
    const char* name;
    const char* scene;
    int code;
    const char* sentence;  ///< part of what is said
};

}  // namespace

TEST_CASE("a scene that cannot be is refused with its place and the remedy", "[extreme]") {
    const Folder folder("hostile");
    folder.write("loose.json", R"({"particles": [[0,0,0],[1,0,0],[2,0,0],[3,0,0]], "masses": 1e-8, "fixed": [0],
                                   "springs": [[0,1,0.9,1,0],[2,3,0.9,1,0]]})");
    folder.write(
        "range.json",
        R"({"particles": [[0,0,0],[1,0,0]], "masses": 1e-8, "fixed": [0], "springs": [[0,7,0.9,1,0]]})");
    folder.write("broken.png", "this is no picture");
    const Hostile cases[] = {
        {"unknown key", "[web]\nspecies = \"araneus_diadematus\"\ndrga = 1\n", 3,
         ":3:1: there is no option 'drga'"},
        {"wrong unit", "[web]\nspecies = \"araneus_diadematus\"\ndrag = \"1 kg\"\n", 3,
         ":3:8: 'drag' is \"1 kg\""},
        {"NaN", "[web]\nspecies = \"araneus_diadematus\"\ndrag = nan\n", 3, ":3:8: 'drag' is nan"},
        {"infinite anchor", "[web]\nanchors = [[0,0,0],[inf,0,0],[0,1,0]]\n", 3, "'anchors' is inf"},
        {"two anchors", "[web]\nanchors = [[0,0,0],[1,0,0]]\n", 3, "has 2 anchors; expected 3 to 1000"},
        {"coincident anchors", "[web]\nanchors = [[0,0,0],[0,0,0],[1,0,0],[0,1,0]]\n", 3, ":2:"},
        {"collinear anchors", "[web]\nanchors = [[0,0,0],[1,0,0],[2,0,0]]\n", 3, ":2:"},
        {"crossing anchors", "[web]\nanchors = [[0,0,0],[1,1,0],[1,0,0],[0,1,0]]\n", 3, ":2:"},
        {"no web at all", "[web]\n", 3, "anchors"},
        {"missing network", "[web]\nnetwork = \"none.json\"\n", 3, "there is no such file"},
        {"two loose parts", "[web]\nnetwork = \"loose.json\"\n", 3, "part"},
        {"index out of range", "[web]\nnetwork = \"range.json\"\n", 3, "7"},
        {"unreadable picture", "[web]\nspecies = \"araneus_diadematus\"\n[view]\nsky = \"broken.png\"\n", 3,
         "broken.png"},
        {"unknown species", "[web]\nspecies = \"araneus_diadematsu\"\n", 3,
         "did you mean \"araneus_diadematus\"?"},
        {"unknown module", "[spyder]\n", 3, "no module answers to [spyder]"},
        {"not TOML", "[web\n", 3, ":1:"},
    };
    for (const Hostile& hostile : cases) {
        CAPTURE(hostile.name);
        const std::string scene = folder.write("scene.toml", hostile.scene);
        const Outcome outcome = run_program("check " + scene);
        CAPTURE(outcome.text);
        CHECK(outcome.code == hostile.code);
        CHECK(outcome.text.find(hostile.sentence) != std::string::npos);
    }
}

TEST_CASE("all faults of a scene are named at once", "[scene]") {
    const Folder folder("hostile");
    const std::string scene = folder.write(
        "scene.toml", "[scene]\nstep = \"1 kg\"\n[web]\ndrga = 1\n[spyder]\n[wind]\nmodel = \"stady\"\n");
    const Outcome outcome = run_program("check " + scene);
    for (const char* part : {"'step'", "'drga'", "[spyder]", "did you mean \"steady\"?"}) {
        CAPTURE(part, outcome.text);
        CHECK(outcome.text.find(part) != std::string::npos);
    }
}

TEST_CASE("an unstable step is refused, substepped or obeyed as the scene says", "[extreme]") {
    const Folder folder("hostile");
    const std::string run = "run " + scene_path("thesis_web") + " --duration 1 --set web.step=0.02 --report " +
                            folder.path("r.json");

    const Outcome stop = run_program(run + " --set web.on_unstable=stop");
    CAPTURE(stop.text);
    CHECK(stop.code == 4);
    CHECK(stop.text.find("set by spring") != std::string::npos);

    const Outcome substep = run_program(run + " --set web.on_unstable=substep");
    CAPTURE(substep.text);
    CHECK(substep.code == 0);

    const Outcome obey = run_program(run + " --set web.on_unstable=as_asked");
    CAPTURE(obey.text);
    CHECK(obey.code == 4);
    for (const char* part : {"web", "particle", "step", "time"}) {
        CAPTURE(part);
        CHECK(obey.text.find(part) != std::string::npos);
    }
}

TEST_CASE("outputs that cannot be written end the run in words and leave nothing half-written", "[extreme]") {
    const Folder folder("hostile");
    folder.write("file", "x");
    const std::string run = "run " + scene_path("strand") + " --duration 0.2 --quiet ";
    for (const char* option : {"--trajectory ", "--telemetry ", "--report ", "--frames ", "--save-state "}) {
        CAPTURE(option);
        const std::string below_a_file = folder.path("file/out");
        std::string arguments = run;
        if (std::string(option) == "--frames ")
            arguments = "run " + scene_path("meadow") + " --duration 0.1 --quiet ";
        arguments += option;
        arguments += below_a_file;
        const Outcome outcome = run_program(arguments);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 1);
        CHECK(outcome.text.find("file/out") != std::string::npos);
    }
    const Outcome full =
        run_program("run " + scene_path("strand") + " --duration 0.2 --quiet --telemetry /dev/full/x.csv");
    CHECK(full.code == 1);
}

TEST_CASE("an output never takes the place of what the scene reads", "[extreme]") {
    const Folder folder("hostile");
    const std::string network = R"({"particles": [[0,0,0],[1,0,0]], "masses": 1, "fixed": [0],
                                    "springs": [[0,1,1,10,0]]})";
    const std::string net = folder.write("trajectory.json", network);
    const std::string sky = folder.write("sky.png", "no picture");
    const std::string scene = folder.write("s.toml",
                                           "[scene]\nduration = 0.1\n[web]\nnetwork = \"trajectory.json\"\n"
                                           "[view]\nsky = \"sky.png\"\n");
    for (const char* option : {"--report", "--telemetry", "--save-state"})
        for (const std::string& path : {net, folder.path("./trajectory.json"), scene}) {
            const Outcome outcome = run_program("run " + scene + " " + option + " " + path);
            CAPTURE(outcome.text);
            CHECK(outcome.code == 2);
            CHECK(outcome.text.find(std::string(option) + ": '" + path + "' is " +
                                    (path == scene ? "the scene" : "what 'web.network' of the scene reads") +
                                    "; name another") != std::string::npos);
        }
    CHECK(run_program("run " + scene + " --trajectory " + folder.path("")).code == 2);
    CHECK(run_program("run " + scene + " --frames " + folder.path("f") + " --video " + sky).code == 2);
    CHECK(read_file(net) == network);
    CHECK(read_file(sky) == "no picture");
    CHECK(run_program("run " + scene + " --quiet --report " + folder.path("r.json")).code == 0);
}

TEST_CASE("a file-size limit stops a trajectory with exit code 5 and no file under its final name",
          "[extreme]") {
    const Folder folder("hostile");
    const std::string command = "(ulimit -f 64; '" ORBWEAVER_PROGRAM "' run " + scene_path("meadow") +
                                " --duration 2 --quiet --trajectory " + folder.path("t") + ") 2>&1";
    const int status = ::system((command + " > " + folder.path("log")).c_str());
    std::ifstream log(folder.path("log"));
    const std::string text((std::istreambuf_iterator<char>(log)), {});
    CAPTURE(text);
    CHECK(WEXITSTATUS(status) == 5);
    CHECK_FALSE(std::filesystem::exists(folder.path("t/web.position.npy")));
    CHECK_FALSE(std::filesystem::exists(folder.path("t/.web.position.part0.npy")));
}

TEST_CASE("more pictures a second than frames are refused, and fewer than one are one", "[scene]") {
    const Folder folder("hostile");
    const std::string run = "run " + scene_path("meadow") + " --duration 0.1 --size 64x48 --video " +
                            folder.path("a.webp") + " --fps ";
    const Outcome many = run_program(run + "61");
    CAPTURE(many.text);
    CHECK(many.code == 3);
    CHECK(many.text.find("--fps: 61 pictures a second of 60 frames a second; expected at most 60") !=
          std::string::npos);
    const Outcome few = run_program(run + "0.3");
    CAPTURE(few.text);
    CHECK(few.code == 0);
    CHECK(few.text.find("  video      " + folder.path("a.webp")) != std::string::npos);
    CHECK(std::filesystem::file_size(folder.path("a.webp")) > 0);
}

TEST_CASE("a video keeps its good pictures when another output's disk is full", "[extreme]") {
    const Folder folder("hostile");
    // 4 kB: telemetry outgrows it after some frames, the video does not.
    const std::string command = "(ulimit -f 8; '" ORBWEAVER_PROGRAM "' run " + scene_path("meadow") +
                                " --duration 2 --quiet --size 16x16 --fps 1 --telemetry " +
                                folder.path("c.csv") + " --video " + folder.path("a.webp") + ") > " +
                                folder.path("log") + " 2>&1";
    CHECK(WEXITSTATUS(::system(command.c_str())) == 5);
    CHECK(std::filesystem::exists(folder.path("a.webp")));
    CHECK_FALSE(std::filesystem::exists(folder.path("c.csv")));
}
