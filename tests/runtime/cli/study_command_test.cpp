#include <algorithm>
#include <catch2/catch.hpp>

#include "support/program.hpp"

using namespace orbweaver::test;

namespace {

struct Scene {
    Folder folder;
    std::string path =
        folder.write("scene.toml", "[scene]\nduration = 0.2\nstep = 0.01\n[oscillator]\nomega = 100\n");
    std::string out = folder.path("out");

    std::vector<std::string> study(const std::string& kind, std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"study", kind, path, "--modules", fixture("oscillator")};
        all.insert(all.end(), more.begin(), more.end());
        if (std::find(more.begin(), more.end(), "--out") == more.end()) all.insert(all.end(), {"--out", out});
        return all;
    }
};

}  // namespace

TEST_CASE("the study's help tells every kind, every option and what is left", "[scene]") {
    const Outcome outcome = run_program({"study", "--help"});
    CHECK(outcome.code == 0);
    for (const char* word : {"accuracy",
                             "stability",
                             "queries",
                             "ik",
                             "SCENE",
                             "--out",
                             "--method",
                             "--axis",
                             "PATH=LOW..HIGH:COUNT",
                             "PATH=A,B",
                             "--repeats",
                             "--time",
                             "--table",
                             "--threads",
                             "--quiet",
                             "--set",
                             "--duration",
                             "accuracy.csv",
                             "accuracy_statistics.csv",
                             "stability.csv",
                             "queries.csv",
                             "ik.csv",
                             "method,step_s,tolerance,error_m,wall_s,steps,outcome",
                             "index.html"}) {
        CAPTURE(word);
        CHECK_THAT(outcome.out, Catch::Contains(word));
    }
}

TEST_CASE("a study of accuracy prints what it comes to", "[scene]") {
    const Scene scene;
    const Outcome outcome = run_program(scene.study("accuracy", {"--repeats", "1", "--quiet"}));
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    for (const char* word : {"conditioning: ", "(by rk4 at ", "reference: rk4", "within 1e-", "written: "})
        CHECK_THAT(outcome.out, Catch::Contains(word));
    CHECK_THAT(read_file(scene.out + "/accuracy.csv"),
               Catch::StartsWith("method,step_s,tolerance,error_m,wall_s,steps,outcome\nexplicit,"));
}

TEST_CASE("a study of stability takes its axes and methods from the command line", "[scene]") {
    const Scene scene;
    const Outcome outcome = run_program(scene.study(
        "stability", {"--axis", "oscillator.step=1..10 ms:4", "--axis", "oscillator.omega=10..1000:3",
                      "--method", "rk4", "--method", "verlet", "--duration", "0.1"}));
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("rk4: "));
    CHECK_THAT(outcome.err, Catch::Contains("24/24 cells"));
    CHECK_THAT(read_file(scene.out + "/stability.csv"),
               Catch::StartsWith("method,oscillator.step,oscillator.omega,class\nverlet,0.001,10,"));
}

TEST_CASE("a study that was asked for wrongly ends with code 2 and says why", "[extreme]") {
    const Scene scene;
    struct Case {
        std::vector<std::string> arguments;
        const char* sentence;
    };
    const Case cases[] = {
        {{"study"}, "KIND is required"},
        {{"study", "beauty", scene.path, "--out", scene.out}, "beauty"},
        {{"study", "accuracy", scene.path}, "--out is required"},
        {scene.study("accuracy", {"--out", ""}), "'' is not a folder; name one"},
        {scene.study("accuracy", {"--axis", "a.b=1..2:3"}), "only stability has axes"},
        {scene.study("stability", {"--repeats", "2"}), "a map is not timed"},
        {scene.study("stability", {"--axis", "a.b"}), "'a.b' is not an axis; expected PATH=LOW..HIGH:COUNT"},
        {scene.study("stability", {"--axis", "a.b=2..1:3"}), "with LOW below HIGH"},
        {scene.study("stability", {"--axis", "a.b=1..2:0"}), "a COUNT of 2 to 200"},
        {scene.study("stability", {"--axis", "a.b=1..2:99999"}), "a COUNT of 2 to 200"},
        {scene.study("stability", {"--axis", "a.b=1..nan:3"}), "'a.b=1..nan:3' is not an axis"},
        {scene.study("stability", {"--axis", "a.b=1 furlong..2 furlong:3"}), "known units"},
        {scene.study("stability", {"--axis", "a.b=1,"}), "PATH=A,B,... with 2 to 200 values"},
        {scene.study("stability", {"--axis", "a.b=1..2:3", "--axis", "a.b=1..4:3"}),
         "'a.b' is named twice; name two options"},
        {scene.study("stability", {"--axis", "a.b=1..2:3", "--axis", "a.c=1..4:3", "--axis", "a.d=1..4:3"}),
         "a map has two"},
        {scene.study("queries", {"--axis", "a.b=1..2:3"}), "only stability has axes"},
        {scene.study("queries", {"--references", "rk4,verlet"}), "queries are held against every triangle"},
        {scene.study("ik", {"--references", "rk4,verlet"}), "limbs are held against their own geometry"},
        {scene.study("accuracy", {"--time", "0"}), "'0' is not a time above 0"},
        {scene.study("accuracy", {"--time", "3 m"}), "'3 m' is not a time above 0"},
        {scene.study("accuracy", {"--repeats", "0"}), "--repeats"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.sentence);
        const Outcome outcome = run_program(c.arguments);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err + outcome.out, Catch::Contains(c.sentence));
    }
    CHECK_FALSE(std::filesystem::exists(scene.out));
}

TEST_CASE("axes that a study cannot vary end with code 3, before anything is run", "[extreme]") {
    const Scene scene;
    for (const char* axis :
         {"scene.duration=1..2:3", "oscillator.method=rk4,verlet", "oscillator.colour=1,2",
          "oscillator.on_unstable=stop,start", "oscillator.step=1,2 kg", "wind.speed=1..2:3"}) {
        CAPTURE(axis);
        const Outcome outcome = run_program(scene.study("stability", {"--axis", axis}));
        CHECK(outcome.code == 3);
        CHECK_THAT(outcome.err, Catch::Contains("error: --axis "));
        CHECK_FALSE(std::filesystem::exists(scene.out));
    }
}

TEST_CASE("labels of an axis come back in the CSV", "[scene]") {
    const Scene scene;
    const Outcome outcome = run_program(
        scene.study("stability", {"--axis", "oscillator.on_unstable=stop,substep", "--method", "rk4"}));
    CHECK(outcome.code == 0);
    const std::string csv = read_file(scene.out + "/stability.csv");
    CHECK_THAT(csv, Catch::StartsWith("method,oscillator.step,oscillator.on_unstable,class\nrk4,"));
    CHECK_THAT(csv, Catch::Contains(",stop,stable\n") && Catch::Contains(",substep,stable\n"));
}

TEST_CASE("a scene that cannot be studied ends with the code of its fault", "[extreme]") {
    const Scene scene;
    CHECK(run_program(scene.study("accuracy", {"--method", "rk5"})).code == 3);
    CHECK(run_program(scene.study("stability", {"--axis", "oscillator.mass=1..2:3"})).code == 3);
    CHECK(run_program(scene.study("accuracy", {"--set", "oscillator.colour=3"})).code == 3);
    CHECK(run_program(scene.study("accuracy", {"--time", "1e-5"})).code == 5);
    scene.folder.write("file", "in the way");
    const Outcome outcome = run_program(scene.study("accuracy", {"--out", scene.folder.path("file")}));
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Catch::Contains("file/accuracy.csv: cannot be written"));
}

TEST_CASE("a signal ends a study with what it found", "[scene]") {
    const Scene scene;
    // Two references of about 0.3 s, then 20 cells that take as long each.
    Program program(
        scene.study("stability", {"--set", "oscillator.delay=0.015", "--method", "verlet", "--axis",
                                  "oscillator.step=0.1..10 ms:10", "--axis", "oscillator.stiffness=1,2"}));
    for (int i = 0; i < 200 && !std::filesystem::exists(scene.out); ++i) ::usleep(10000);
    ::usleep(3000000);
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("interrupted: what was not run is unknown"));
    CHECK_THAT(read_file(scene.out + "/stability.csv"),
               Catch::Contains("unknown") && (Catch::Contains("stable") || Catch::Contains("diverged")));
}

TEST_CASE("a signal before anything is found leaves nothing, and says so", "[extreme]") {
    const Scene scene;
    for (const char* kind : {"accuracy", "stability"}) {
        Program program(scene.study(kind, {"--set", "oscillator.delay=0.2"}));
        for (int i = 0; i < 200 && !std::filesystem::exists(scene.out); ++i) ::usleep(10000);
        ::usleep(100000);
        program.send(SIGINT);
        const Outcome outcome = program.wait();
        CHECK(outcome.code == 5);
        CHECK_THAT(outcome.err, Catch::Contains("error: interrupted before "));
        CHECK_FALSE(std::filesystem::exists(scene.out));
    }
}
