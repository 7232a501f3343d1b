#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "sanitized.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;
using nlohmann::json;

namespace {

/// What a run in a process of its own reports.
json report_of_run(const std::string& arguments, const std::string& environment = "") {
    const Folder folder("crawler");
    const Outcome outcome =
        run_program("run " + arguments + " --quiet --report " + folder.path("report.json"), environment);
    INFO(arguments << "\n" << outcome.text);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.text.find("warning") == std::string::npos);
    return json::parse(std::ifstream(folder.path("report.json")));
}

std::vector<json> crawlers_in(const json& report) {
    std::vector<json> found;
    for (const json& module : report["modules"])
        if (module["module"] == "crawler") found.push_back(module);
    return found;
}

}  // namespace

TEST_CASE("every scene of crawlers runs a second without a warning and accounts for it in numbers", "[scene]") {
    struct Case {
        const char* name;
        std::size_t crawlers;
    };
    const Case each = GENERATE(Case{"worm", 1}, Case{"snake", 1}, Case{"sidewinder", 1}, Case{"caterpillar", 1},
                               Case{"grip", 2}, Case{"worm_cliff", 1}, Case{"caterpillar_branch", 1},
                               Case{"snake_hill", 1}, Case{"garden", 3});
    CAPTURE(each.name);
    const json report = report_of_run(scene_path(each.name) + " --duration " + (kSanitized ? "0.1" : "1"));
    const std::vector<json> crawlers = crawlers_in(report);
    REQUIRE(crawlers.size() == each.crawlers);
    for (const json& crawler : crawlers) {
        for (const char* name : {"mean_speed_m_s", "lengths_per_cycle", "max_volume_error", "work_in_j",
                                 "friction_loss_j", "unexplained_share"}) {
            CAPTURE(name);
            REQUIRE(crawler["measures"].contains(name));
            REQUIRE(crawler["measures"][name].is_number());
            CHECK(std::isfinite(crawler["measures"][name].get<double>()));
        }
        CHECK(std::isfinite(crawler["error_estimate"]["value"].get<double>()));
        CHECK(crawler["measures"]["energy_gain_j"] == 0.0);
    }
}

TEST_CASE("on level ground crawlers keep their volume, explain their energy and get on", "[scene]") {
    if (kSanitized) return;
    struct Case {
        const char* name;
        double lengths_per_cycle;
    };
    for (const Case& each : {Case{"worm", 0.05}, {"snake", 0.3}, {"sidewinder", 0.4}, {"caterpillar", 0.2}}) {
        CAPTURE(each.name);
        const json measures = crawlers_in(report_of_run(scene_path(each.name)))[0]["measures"];
        CHECK(measures["unexplained_share"] < 1e-3);
        CHECK(measures["max_volume_error"] < 0.01);
        CHECK(measures["lengths_per_cycle"] > each.lengths_per_cycle);
        CHECK(measures["cost_of_transport"] > 0);
    }
}

TEST_CASE("crawlers end in the same bits and books on two threads, and without wide vectors", "[scene]") {
    for (const char* name : {"worm", "caterpillar", "worm_cliff", "caterpillar_branch"}) {
        CAPTURE(name);
        const std::string arguments = scene_path(name) + " --duration " + (kSanitized ? "0.1" : "0.5");
        const std::string two = arguments + " --set crawler.count=9";
        const json plain = report_of_run(arguments, "ORBWEAVER_PLAIN=1"), wide = report_of_run(arguments);
        const json many = report_of_run(two), threaded = report_of_run(two + " --threads 2");
        CHECK(plain["state_hash"] == wide["state_hash"]);
        CHECK(many["state_hash"] == threaded["state_hash"]);
        CHECK(crawlers_in(plain)[0]["measures"] == crawlers_in(wide)[0]["measures"]);
        CHECK(crawlers_in(many)[0]["measures"] == crawlers_in(threaded)[0]["measures"]);
    }
}

TEST_CASE("a run of crawlers that is saved and gone on from ends in the state and books of the whole",
          "[scene]") {
    const Folder folder("crawler_saved");
    const std::string half = kSanitized ? "0.1" : "0.5", whole = kSanitized ? "0.2" : "1";
    for (const char* name : {"worm", "caterpillar_branch", "snake_hill"}) {
        CAPTURE(name);
        const std::string state = folder.path(std::string(name) + ".state");
        const json all = report_of_run(scene_path(name) + " --duration " + whole);
        report_of_run(scene_path(name) + " --duration " + half + " --save-state " + state);
        const json rest =
            report_of_run(scene_path(name) + " --duration " + whole + " --restore-state " + state);
        CHECK(rest["state_hash"] == all["state_hash"]);
        for (const char* measure : {"work_in_j", "friction_loss_j", "damping_loss_j", "impact_loss_j",
                                    "lift_gain_j", "energy_change_j", "unexplained_energy_j",
                                    "lengths_per_cycle", "max_volume_error", "mean_speed_m_s"}) {
            CAPTURE(measure);
            CHECK(crawlers_in(rest)[0]["measures"][measure] == crawlers_in(all)[0]["measures"][measure]);
        }
    }
}

TEST_CASE("a snake winds along the back of a bunny, as the README has it", "[scene]") {
    const Folder folder("crawler_bunny");
    const std::string scene = folder.write(
        "bunny.toml",
        "[surface]\nmesh = \"" ORBWEAVER_MESHES
        "/stanford-bunny.obj\"\nsize = \"2 m\"\n[[crawler]]\n"
        "kind = \"snake\"\nposition = [-0.05, 1.8, 0.14]\nseek.point = [0.6, 1.3, 0.1]\nadhesion = 2\n"
        "friction = { forward = 0.6, backward = 1.2, sideways = 2 }\n");
    const std::string bake = std::string(ORBWEAVER_ASSETS_PROGRAM) + " bake '" + scene + "' > /dev/null 2>&1";
    REQUIRE(std::system(bake.c_str()) == 0);
    const json report = report_of_run(scene + " --duration " + (kSanitized ? "0.1" : "8"));
    const json measures = crawlers_in(report)[0]["measures"];
    CHECK(measures["points_on_ground"] > 30);
    CHECK(measures["unexplained_share"] < 1e-3);
    if (kSanitized) return;
    CHECK(measures["lengths_per_cycle"] > 0.1);
    CHECK(measures["lift_gain_j"] < 0.001 * measures["work_in_j"].get<double>());
}

TEST_CASE("books that a step too long leaves open are warned of, and waves that steps do not resolve",
          "[scene]") {
    const Folder folder("crawler_steps");
    const auto said = [&](const char* options) {
        const std::string scene =
            folder.write("s.toml", std::string("[[crawler]]\nkind = \"worm\"\n") + options);
        const Outcome outcome = run_program("run " + scene + " --quiet --duration 0.5");
        CHECK(outcome.code == 0);
        return outcome.text;
    };
    CHECK(said("").empty());
    CHECK_THAT(
        said("method = \"implicit_euler\"\nstep = \"16 ms\"\n"),
        Catch::Contains("do not resolve what happened; ask for a shorter 'step', or for symplectic_euler"));
    CHECK_THAT(said("period = \"1 ms\"\n"), Catch::Contains("is shorter than 10 steps of"));
}

TEST_CASE("a worm that falls so fast that it is crushed says so, once, and one that lands whole does not",
          "[extreme]") {
    const Folder folder("crawler_crushed");
    const auto fall = [&](const char* height, const char* duration) {
        const std::string scene = folder.write(
            "s.toml", std::string("[[crawler]]\nkind = \"worm\"\nheight = \"") + height + "\"\ncount = 2\n");
        const Outcome outcome = run_program("run " + scene + " --quiet --duration " + duration);
        CHECK(outcome.code == 0);
        return outcome.text;
    };
    const std::string crushed = fall("2 m", "1");
    CAPTURE(crushed);
    const auto at = crushed.find("is crushed or turned inside out at t = 0.6");
    REQUIRE(at != std::string::npos);
    CHECK(crushed.find("is crushed", at + 1) == std::string::npos);
    CHECK(fall("10 cm", "0.4").find("crushed") == std::string::npos);
}

TEST_CASE("steps that crawlers cannot take are refused, shortened or obeyed in words", "[extreme]") {
    const Folder folder("crawler_unstable");
    const auto run = [&](const char* policy) {
        const std::string scene =
            folder.write("s.toml", std::string("[[crawler]]\nkind = \"worm\"\nstep = 1\non_unstable = \"") +
                                       policy + "\"\n");
        return run_program("run " + scene + " --duration 0.5");
    };
    const Outcome stop = run("stop"), substep = run("substep"), obey = run("as_asked");
    CAPTURE(stop.text, substep.text, obey.text);
    CHECK(stop.code == 4);
    CHECK(stop.text.find("longer than the largest stable one of symplectic_euler") != std::string::npos);
    CHECK(stop.text.find("of crawler 0, particles") != std::string::npos);
    CHECK(substep.code == 0);
    CHECK(substep.text.find("warning: crawler: ") != std::string::npos);
    CHECK(obey.code == 4);
    CHECK(obey.text.find("is kept") != std::string::npos);
}

TEST_CASE("options of crawlers that cannot be are refused with file, line and what is expected", "[extreme]") {
    struct Case {
        const char* name;
        const char* scene;
        const char* sentence;
    };
    const Case cases[] = {
        {"waves too short", "[[crawler]]\nwaves = 7\n",
         ":2:9: waves are shorter than 4 segments; expected at "
         "most 6 of them in 24 segments"},
        {"two goals", "[[crawler]]\nseek.point = [1,0,0]\nfollow_path.points = [[0,0,0],[1,0,0]]\n",
         ":2:14: they are to go to a point and along a path at once"},
        {"a drop without an edge", "[[crawler]]\ncliff.drop = \"3 cm\"\n", ":2:14: a cliff has no edge"},
        {"a radius without an edge", "[[crawler]]\ncliff.radius = \"3 mm\"\n", ":2:16: a cliff has no edge"},
        {"an edge too round", "[[crawler]]\ncliff = { edge = 0, radius = \"2 cm\", drop = \"3 cm\" }\n",
         ":2:30: the rounded edge is higher than half of the cliff"},
        {"a floor beside a surface", "[surface]\nfloor = \"1 m\"\n[[crawler]]\nfloor = 0\n",
         ":4:9: there are two grounds to crawl on"},
        {"a cliff beside a surface", "[surface]\nfloor = \"1 m\"\n[[crawler]]\ncliff.edge = 0\n",
         ":4:14: there are two grounds to crawl on"},
        {"unknown kind", "[[crawler]]\nkind = \"snaek\"\n", "did you mean \"snake\"?"},
        {"unknown gait", "[[crawler]]\ngait = \"rectilinaer\"\n", "did you mean \"rectilinear\"?"},
        {"unknown method", "[[crawler]]\nmethod = \"verlot\"\n", "did you mean \"verlet\"?"},
        {"unknown option", "[[crawler]]\nstrian = 1\n", "did you mean 'strain'?"},
        {"no length", "[[crawler]]\nlength = 0\n", ":2:10: 'length' is 0"},
        {"negative width", "[[crawler]]\nwidth = \"-1 mm\"\n", ":2:9: 'width' is \"-1 mm\""},
        {"length of no number", "[[crawler]]\nlength = nan\n", ":2:10: 'length' is nan"},
        {"endless period", "[[crawler]]\nperiod = inf\n", ":2:10: 'period' is inf"},
        {"no step", "[[crawler]]\nstep = 0\n", ":2:8: 'step' is 0"},
        {"no substeps", "[[crawler]]\nmax_substeps = 0\n", ":2:16: 'max_substeps' is 0"},
        {"huge mass", "[[crawler]]\nmass_scale = 1e16\n", ":2:14: 'mass_scale' is 1e+16"},
        {"huge friction", "[[crawler]]\nfriction.forward = 1e10\n", ":2:20: 'friction.forward' is"},
        {"negative friction", "[[crawler]]\nfriction.forward = -0.1\n", ":2:20: 'friction.forward' is -0.1"},
        {"strain of all", "[[crawler]]\nstrain = 1\n", ":2:10: 'strain' is 1"},
        {"two segments", "[[crawler]]\nsegments = 2\n", ":2:12: 'segments' is 2"},
        {"nobody", "[[crawler]]\ncount = 0\n", ":2:9: 'count' is 0"},
        {"too many", "[[crawler]]\ncount = 10001\n", ":2:9: 'count' is 10001"},
        {"far away", "[[crawler]]\nposition = [1e8, 0, 0]\n", ":2:13: 'position' is"},
        {"heading of no number", "[[crawler]]\nheading = [nan, 0, 0]\n", ":2:12: 'heading' is nan"},
        {"script that turns too far", "[[crawler]]\ncontrol = [{ turn = 2 }]\n",
         ":2:21: 'control.0.turn' is 2"},
        {"script of a spider", "[[crawler]]\ncontrol = [{ speed = 2 }]\n",
         "there is no option 'control.0.speed'; expected one of at, for, pace or turn"},
        {"wrong unit", "[[crawler]]\nwidth = \"1 kg\"\n", ":2:9: 'width' is \"1 kg\""},
    };
    const Folder folder("crawler_hostile");
    for (const Case& each : cases) {
        CAPTURE(each.name);
        const std::string scene = folder.write("scene.toml", each.scene);
        const Outcome outcome = run_program("check " + scene);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 3);
        CHECK(outcome.text.find(scene + ":") != std::string::npos);
        CHECK(outcome.text.find(each.sentence) != std::string::npos);
    }
}
