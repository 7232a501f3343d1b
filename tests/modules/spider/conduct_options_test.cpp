#include "conduct_options.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <set>

#include "checked_options.hpp"
#include "fake_host.hpp"
#include "walker.hpp"

using namespace walker;
using land::Land;

namespace {

const Manifest& manifest() {
    static const Manifest read = orbweaver::test::manifest_of("spider");
    return read;
}

const Land& cube() {
    static const Land land(mesh::cube(2, 4));
    return land;
}

/// A [[spider]] table, checked as the program does, and what becomes of it.
struct Read {
    orbweaver::test::FakeHost host;
    Conduct conduct;
    std::vector<TimedCommand> script;

    explicit Read(const std::string& table) {
        static const Species huntsman = spider::test::creature("huntsman");
        host.options_ = orbweaver::test::checked_options(manifest(), table, host.faults);
        if (host.faults.empty()) conduct = conduct_of(host, cube().surface(), huntsman);
        if (host.faults.empty()) script = control_of(host.options());
    }
    std::vector<std::string> faults() const {
        std::vector<std::string> all;
        for (const Diagnostic& fault : host.faults) all.push_back(to_string(fault));
        return all;
    }
};

double leg() { return mean_leg_length(spider::test::creature("huntsman")); }

}  // namespace

TEST_CASE("every option with a unit arrives in the unit that its reader takes it for", "[unit]") {
    struct Case {
        const char* key;
        const char* table;
        double expected;
        std::function<double(const Read&)> arrived;
    };
    const auto options = [](const char* key) {
        return [key](const Read& r) { return r.host.options_.vector(key).x; };
    };
    const std::string target = "target = \"prey\"";
    const Case cases[] = {
        {"position", "position = [\"20 cm\", 1, 0]", 0.2, options("position")},
        {"speed", "speed = \"30 cm/s\"", 0.3, [](const Read& r) { return r.conduct.pace.top_speed; }},
        {"wander.rate", "wander.rate = \"0.01 kHz\"", 10, [](const Read& r) { return r.conduct.wander.rate; }},
        {"seek.point", "seek.point = [\"20 cm\", 1, 0]", 0.2,
         [](const Read& r) {
             return r.conduct.behaviors.seek.ways.seen_from(spot(cube(), {-0.3, 1, 0.1})).x;
         }},
        {"flee.point", "flee.point = [\"20 cm\", 1, 0]", 0.2,
         [](const Read& r) {
             return r.conduct.behaviors.flee.ways.seen_from(spot(cube(), {-0.3, 1, 0.1})).x;
         }},
        {"flee.within", "flee = { point = [0, 1, 0], within = \"30 mm\" }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.flee_within; }},
        {"arrive.point", "arrive.point = [\"20 cm\", 1, 0]", 0.2,
         [](const Read& r) {
             return r.conduct.behaviors.arrive.ways.seen_from(spot(cube(), {-0.3, 1, 0.1})).x;
         }},
        {"arrive.slowing", "arrive = { point = [0, 1, 0], slowing = \"30 mm\" }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.slowing; }},
        {"evade.within", "evade = { target = \"hunter\", within = \"30 mm\" }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.evade_within; }},
        {"follow_path.points", "follow_path.points = [[\"20 cm\", 1, 0]]", 0.2,
         [](const Read& r) { return r.conduct.behaviors.path.at(0).x; }},
        {"follow_path.ahead", "follow_path = { points = [[0, 1, 0]], ahead = \"30 mm\" }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.path_ahead; }},
        {"avoid_obstacles.centers", "avoid_obstacles = { centers = [[\"20 cm\", 1, 0]], radii = [0] }", 0.2,
         [](const Read& r) { return r.conduct.behaviors.obstacles.at(0).center.x; }},
        {"avoid_obstacles.radii", "avoid_obstacles = { centers = [[0, 1, 0]], radii = [\"30 mm\"] }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.obstacles.at(0).radius - leg(); }},
        {"keep_apart.reach", "keep_apart.reach = \"30 mm\"", 0.03,
         [](const Read& r) { return r.conduct.behaviors.apart; }},
        {"follow_wall.distance", "follow_wall = { climb = 0, distance = \"30 mm\" }", 0.03,
         [](const Read& r) { return r.conduct.behaviors.walls.distance; }},
        {"follow_wall.time", "follow_wall = { climb = 0, time = \"0.1 min\" }", 6,
         [](const Read& r) { return r.conduct.behaviors.walls.time; }},
        {"control.*.at", "control = [{ at = \"300 ms\" }]", 0.3,
         [](const Read& r) { return r.script.at(0).begin; }},
        {"control.*.for", "control = [{ for = \"300 ms\" }]", 0.3,
         [](const Read& r) { return r.script.at(0).end; }},
        {"control.*.speed", "control = [{ speed = \"-30 cm/s\" }]", -0.3,
         [](const Read& r) { return r.script.at(0).command.speed; }},
        {"control.*.turn", "control = [{ turn = \"1 rad/s\" }]", 180 / 3.14159265358979323846,
         [](const Read& r) { return r.script.at(0).command.turn; }},
        {"turn_rate", "turn_rate = \"1 rad/s\"", 180 / 3.14159265358979323846,
         [](const Read& r) { return r.conduct.turn_rate; }},
    };
    std::set<std::string> with_unit, tested;
    for (const OptionSpec& spec : manifest().options)
        if (spec.unit != "1" || spec.key == "avoid_obstacles.radii") with_unit.insert(spec.key);
    for (const Case& c : cases) {
        INFO(c.table);
        tested.insert(c.key);
        const Read read(c.table);
        CHECK(read.faults().empty());
        CHECK(c.arrived(read) == Approx(c.expected).epsilon(1e-12));
    }
    CHECK(tested == with_unit);
}

TEST_CASE("who has somewhere to go does not wander, unless that is asked for", "[unit]") {
    CHECK(Read("").conduct.behaviors.wander == 1);
    CHECK(Read("flee.point = [0, 1, 0]").conduct.behaviors.wander == 1);
    CHECK(Read("evade.target = \"hunter\"").conduct.behaviors.wander == 1);
    for (const char* goal : {"seek.point = [0, 1, 0]", "arrive.point = [0, 1, 0]", "pursue.target = \"prey\"",
                             "follow_path.points = [[0, 1, 0]]"}) {
        CHECK(Read(goal).conduct.behaviors.wander == 0);
        CHECK(Read(std::string(goal) + "\nwander.rate = 3").conduct.behaviors.wander == 1);
        CHECK(Read(std::string(goal) + "\nwander.weight = 0.5").conduct.behaviors.wander == 0.5);
    }
}

TEST_CASE("behaviors are there when the scene says what they are about, with their weights", "[unit]") {
    const Behaviors none = Read("").conduct.behaviors;
    for (const double weight : {none.seek.weight, none.flee.weight, none.arrive.weight, none.pursue, none.evade,
                                none.follow_path, none.avoid_obstacles, none.follow_wall})
        CHECK(weight == 0);
    CHECK(none.keep_apart == 3);
    CHECK(Read("seek.point = [0, 1, 0]").conduct.behaviors.seek.weight == 1);
    CHECK(Read("evade = { target = \"x\", weight = 7 }").conduct.behaviors.evade == 7);
    CHECK(Read("follow_wall.climb = 0.5").conduct.behaviors.walls.distance == leg());
}

TEST_CASE("a path is laid along the surface, over its edges", "[unit]") {
    const Behaviors behaviors =
        Read("follow_path = { points = [[0.8, 1, 0], [1, 0.7, 0]], loop = true, ahead = 0.1 }")
            .conduct.behaviors;
    CHECK(behaviors.loop);
    REQUIRE(behaviors.path.size() > 35);  // a metre there and back in steps of 2.5 cm
    for (const Vec3& p : behaviors.path) CHECK(std::max(p.x, p.y) == Approx(1).epsilon(1e-12));
    CHECK(behaviors.path.front() == Vec3{0.8, 1, 0});
    CHECK(distance(behaviors.path.back(), behaviors.path.front()) < 0.026);
    CHECK(distance(behaviors.path.back(), behaviors.path.front()) > 1e-6);
}

TEST_CASE("commands stand in order of their begins, whatever the scene's", "[unit]") {
    const auto script =
        Read("[[control]]\nat = 3\nspeed = 0.1\n[[control]]\nfor = 1\n[[control]]\nat = 2\nturn = 9\n").script;
    REQUIRE(script.size() == 3);
    CHECK(script[0].begin == 0);
    CHECK(script[0].end == 1);
    CHECK(script[1].command.turn == 9);
    CHECK(std::isinf(script[1].end));
    CHECK(script[2].command.speed == 0.1);
}

TEST_CASE("what a behavior lacks is named with its place", "[extreme]") {
    CHECK(
        Read("seek.weight = 3").faults() ==
        std::vector<std::string>{"scene.toml:1:15: 'seek.point' is missing; expected what 'seek.weight' is to "
                                 "count for; add it, or leave 'seek.weight' out"});
    CHECK(Read("pursue.weight = 3").faults().size() == 1);
    CHECK(Read("follow_path.points = []").faults() ==
          std::vector<std::string>{
              "scene.toml:1:22: 'follow_path.points' is empty; expected at least one point"});
    CHECK(Read("avoid_obstacles.centers = [[0, 1, 0], [1, 1, 0]]\navoid_obstacles.radii = [1]").faults() ==
          std::vector<std::string>{
              "scene.toml:2:25: 2 obstacles have 1 radii; expected as many radii as centers"});
}

TEST_CASE("legs are a little off their time, and swing as they are for, unless a scene says otherwise",
          "[unit]") {
    CHECK(Read("").conduct.jitter == 0.02);
    CHECK(Read("jitter = 0").conduct.jitter == 0);
    CHECK(Read("").conduct.path == nullptr);
    CHECK(Read("path = \"arc\"").conduct.path == find_stride_path("arc"));
    CHECK(Read("").conduct.wander.on_ball);
    CHECK_FALSE(Read("wander.form = \"circle\"").conduct.wander.on_ball);
}

TEST_CASE("turns and motion are as the table says", "[unit]") {
    const Read read("turn_curve = \"slow_in_slow_out\"\nturn_steps = 30\norient_every = 6\nmotion = \"rk4\"");
    CHECK(read.faults().empty());
    CHECK(read.conduct.turn_curve == TurnCurve::slow_in_slow_out);
    CHECK(read.conduct.turn_steps == 30);
    CHECK(read.conduct.orient_every == 6);
    CHECK(read.conduct.motion == MotionMethod::rk4);
    CHECK(Read("").conduct.turn_curve == TurnCurve::linear);
    CHECK(Read("").conduct.orient_every == 1);
    CHECK(Read("").conduct.motion == MotionMethod::euler);
}
