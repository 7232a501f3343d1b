#include "crawler_options.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "checked_options.hpp"
#include "fake_host.hpp"
#include "spider/land.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;
using land::Land;

namespace {

constexpr double kG = 9.81;

const Manifest& manifest() {
    static const Manifest read = orbweaver::test::manifest_of("crawler");
    return read;
}

/// A [[crawler]] table, checked as the program does, and what becomes of it on a surface, or on none.
struct Read {
    Diagnostics faults;
    Crawler crawler;
    Ground ground;
    std::vector<Vec3> places;

    explicit Read(const std::string& table, const Surface* surface = nullptr) {
        const Options options = orbweaver::test::checked_options(manifest(), table, faults);
        if (!faults.empty()) return;
        crawler = read_crawler(options, {0, -kG, 0}, faults);
        ground = read_ground(options, crawler, surface, nullptr, faults);
        places = read_places(options, crawler, surface, faults);
    }
    std::string fault() const { return faults.empty() ? "" : to_string(faults.front()); }
    /// m, of a body's mass.
    Vec3 middle(std::size_t body = 0) const {
        Vec3 sum;
        const std::size_t each = places.size() / crawler.count;
        for (std::size_t i = body * each; i < (body + 1) * each; ++i) sum += places[i];
        return sum / static_cast<double>(each);
    }
    double lowest() const {
        return std::min_element(places.begin(), places.end(),
                                [](const Vec3& a, const Vec3& b) { return a.y < b.y; })
            ->y;
    }
    /// Of a ring, unit: from below to above.
    Vec3 up(std::size_t ring) const {
        const Vec3* c = &places[kCorners * ring];
        const Vec3 way = c[2] + c[3] - c[0] - c[1];
        return way / norm(way);
    }
};

const char* kSmall = "segments = 10\nlength = 0.1\nwidth = 0.01\nwaves = 1\n";

const Land& floor_land() {
    static const Land land(land::crates_on_a_floor());
    return land;
}

}  // namespace

TEST_CASE("springs are as strong and as damped as strength, damping and time unit say in masses of a point",
          "[unit]") {
    const Read read(std::string(kSmall) + "density = 500\nstrength = 3\ndamping = 2\ntime_unit = \"2 ms\"\n");
    REQUIRE(read.fault().empty());
    const Build& build = read.crawler.build;
    CHECK(build.mass == Approx(500 * 0.1 * 0.01 * 0.01));
    CHECK(build.stiffness == Approx(3 * build.point_mass() / 4e-6));
    CHECK(build.damping == Approx(2 * build.point_mass() / 2e-3));
}

TEST_CASE("each scale changes one thing alone", "[unit]") {
    const Build plain = Read(kSmall).crawler.build;
    const auto scaled = [&](const char* key) {
        return Read(std::string(kSmall) + key + "_scale = 1000\n").crawler.build;
    };
    const Build stiff = scaled("stiffness"), heavy = scaled("mass"), damped = scaled("damping");
    CHECK(stiff.stiffness == Approx(1000 * plain.stiffness));
    CHECK(stiff.mass == plain.mass);
    CHECK(stiff.damping == plain.damping);
    CHECK(heavy.mass == Approx(1000 * plain.mass));
    CHECK(heavy.stiffness == plain.stiffness);
    CHECK(heavy.damping == plain.damping);
    CHECK(damped.damping == Approx(1000 * plain.damping));
    CHECK(damped.mass == plain.mass);
    CHECK(damped.stiffness == plain.stiffness);
}

TEST_CASE("curvatures are those of a length, and adhesion is over what the points at the bottom carry",
          "[unit]") {
    const Read read(std::string(kSmall) +
                    "strain = 0.3\nbend = 6\nlift = 2\nturn = 1\nadhesion = 3\n[friction]\n"
                    "forward = 1\nbackward = 2\nsideways = 3\nlaw = \"one_way\"\n");
    REQUIRE(read.fault().empty());
    CHECK(read.crawler.effort.strain == 0.3);
    CHECK(read.crawler.effort.bend == Approx(60));
    CHECK(read.crawler.effort.lift == Approx(20));
    CHECK(read.crawler.effort.turn == Approx(10));
    CHECK(read.crawler.friction.adhesion == Approx(2 * 3 * kG));
    CHECK(read.crawler.friction.forward == 1);
    CHECK(read.crawler.friction.backward == 2);
    CHECK(read.crawler.friction.sideways == 3);
    CHECK(read.crawler.friction.law == FrictionLaw::one_way);
    CHECK(Read(kSmall).crawler.friction.law == FrictionLaw::coulomb);
}

TEST_CASE("a kind brings the options of its file, and those of the scene go before them", "[unit]") {
    const Read snake("kind = \"snake\"\n"), slow("kind = \"snake\"\nperiod = \"4 s\"\n");
    REQUIRE(snake.fault().empty());
    CHECK(snake.crawler.gait->name == "undulation");
    CHECK(snake.crawler.build.segments == 40);
    CHECK_FALSE(snake.crawler.build.keeps_volume);
    CHECK(slow.crawler.period == 4);
    CHECK(slow.crawler.build.segments == 40);
    const Read worm("kind = \"worm\"\n"), caterpillar("kind = \"caterpillar\"\n");
    CHECK(worm.crawler.gait->name == "rectilinear");
    CHECK(caterpillar.crawler.gait->name == "caterpillar");
    CHECK(caterpillar.crawler.friction.adhesion > 0);
}

TEST_CASE("a path is looked half a length ahead unless the scene says otherwise", "[unit]") {
    const std::string path = std::string(kSmall) + "[follow_path]\npoints = [[0, 0, 0], [1, 0, 0]]\n";
    const Read plain(path), told(path + "ahead = \"3 cm\"\nloop = true\n");
    REQUIRE(plain.crawler.path);
    CHECK(plain.crawler.path->ahead == Approx(0.05));
    CHECK_FALSE(plain.crawler.path->loop);
    CHECK(told.crawler.path->ahead == Approx(0.03));
    CHECK(told.crawler.path->loop);
    CHECK_FALSE(Read(kSmall).crawler.path);
}

TEST_CASE("a script is in the order of its begins, at full pace and straight where it says nothing", "[unit]") {
    const Read read(std::string(kSmall) +
                    "control = [{ at = 2, turn = 1 }, { for = 1, pace = 0.5 }, { at = 1, for = 3 }]\n");
    const auto& script = read.crawler.script;
    REQUIRE(script.size() == 3);
    CHECK(script[0].begin == 0);
    CHECK(script[0].end == 1);
    CHECK(script[0].command.pace == 0.5);
    CHECK(script[0].command.turn == 0);
    CHECK(script[1].begin == 1);
    CHECK(script[1].end == 4);
    CHECK(script[1].command.pace == 1);
    CHECK(script[2].begin == 2);
    CHECK(std::isinf(script[2].end));
    CHECK(script[2].command.turn == 1);
}

TEST_CASE(
    "a straight body lies on the floor with its middle where it is asked for, and looks along its heading",
    "[unit]") {
    const Read read(std::string(kSmall) +
                    "floor = 0.7\nposition = [1, 5, 2]\nheading = [0, 0.5, -1]\nheight = 0.25\n");
    REQUIRE(read.fault().empty());
    CHECK(read.places.size() == 44);
    CHECK(distance(read.middle(), {1, 0.7 + 0.25 + 0.005, 2}) < 1e-12);
    CHECK(read.lowest() == Approx(0.95));
    CHECK(distance(ring_middle(&read.places[40]), {1, 0.955, 1.95}) < 1e-12);  // its head
    CHECK(distance(read.up(3), {0, 1, 0}) < 1e-12);
}

TEST_CASE("a heading that the ground does not let it take, or none, still gives a body", "[unit]") {
    for (const char* heading : {"[0, 1, 0]", "[0, 0, 0]", "[0, -1, 0]"}) {
        const Read read(std::string(kSmall) + "heading = " + heading + "\n");
        CHECK(distance(ring_middle(read.places.data()), ring_middle(&read.places[40])) == Approx(0.1));
        CHECK(read.lowest() == Approx(0).margin(1e-12));
    }
}

TEST_CASE("upside down, a body lies where it would on its belly", "[unit]") {
    const Read read(std::string(kSmall) + "upside_down = true\n");
    CHECK(read.lowest() == Approx(0).margin(1e-12));
    CHECK(distance(read.up(0), {0, -1, 0}) < 1e-12);
    const auto volume_of = [](const Read& each) {
        return volume({1, each.crawler.build.segments}, each.places);
    };
    CHECK(volume_of(read) == Approx(volume_of(Read(kSmall))));  // turned, not mirrored
    CHECK(volume_of(read) > 0);
}

TEST_CASE("bodies lie side by side to the right, four widths apart unless the scene says otherwise", "[unit]") {
    const Read read(std::string(kSmall) + "count = 3\n"),
        wide(std::string(kSmall) + "count = 3\nspacing = \"20 cm\"\n");
    for (const std::size_t body : {0u, 1u, 2u}) {
        const double number = static_cast<double>(body);
        CHECK(distance(read.middle(body), {0, 0.005, 0.04 * number}) < 1e-12);
        CHECK(distance(wide.middle(body), {0, 0.005, 0.2 * number}) < 1e-12);
    }
}

TEST_CASE("on a surface a body lies along it, on the nearest point, and straight on beyond its border",
          "[unit]") {
    const Land& land = floor_land();
    const Read flat(std::string(kSmall) + "position = [0.35, 0.2, -0.3]\n", &land.surface());
    REQUIRE(flat.fault().empty());
    CHECK(distance(flat.middle(), {0.35, 0.005, -0.3}) < 1e-9);
    const Read over(std::string(kSmall) + "position = [0.49, 0.2, -0.3]\n", &land.surface());
    REQUIRE(over.fault().empty());
    CHECK(over.middle().x == Approx(0.49));
    CHECK(over.lowest() == Approx(0).margin(1e-9));
    CHECK(ring_middle(&over.places[40]).x == Approx(0.54));
}

TEST_CASE("a body bends over an edge of a surface, a fixed way off it", "[unit]") {
    const Land cube(mesh::cube(1, 2));
    const Read read(std::string(kSmall) + "position = [0.48, 1, 0.1]\n", &cube.surface());
    REQUIRE(read.fault().empty());
    CHECK(distance(read.up(0), {0, 1, 0}) < 1e-9);
    CHECK(distance(read.up(10), {1, 0, 0}) < 1e-9);
    for (std::size_t ring = 0; ring <= 10; ++ring) {
        const Vec3 middle = ring_middle(&read.places[4 * ring]);
        CHECK(std::max(middle.x, middle.y) == Approx(0.505));
    }
}

TEST_CASE("beyond a cliff's edge a body lies on the floor below", "[unit]") {
    const std::string cliff = std::string(kSmall) + "floor = 0.3\ncliff = { edge = 0, drop = \"20 cm\" }\n";
    CHECK(Read(cliff + "position = [0.2, 0, 0]\n").lowest() == Approx(0.1));
    CHECK(Read(cliff + "position = [0.03, 0, 0]\n").lowest() == Approx(0.3));  // its tail is on the upper one
    CHECK(Read(cliff + "position = [-0.2, 0, 0]\n").lowest() == Approx(0.3));
}

TEST_CASE("there is a level floor unless a surface or a cliff is there", "[unit]") {
    CHECK(std::get<Floor>(Read("floor = 0.3\n").ground).height == 0.3);
    const Read cliff("floor = 0.3\ncliff = { edge = 0.1, radius = \"2 cm\", drop = \"4 cm\" }\n");
    REQUIRE(cliff.fault().empty());
    CHECK(std::get<Cliff>(cliff.ground).height == 0.3);
    CHECK(std::get<Cliff>(cliff.ground).edge == 0.1);
    CHECK(std::get<Cliff>(cliff.ground).radius == 0.02);
    CHECK(std::get<Cliff>(cliff.ground).drop == 0.04);
    CHECK(std::holds_alternative<SurfaceGround>(Read("", &floor_land().surface()).ground));
}

TEST_CASE("bends and lifts a quarter of a wave apart may each be sharp, and turns that nobody asks for",
          "[unit]") {
    const std::string body = "length = 0.1\nwidth = 0.01\nturn = 19\ngait = \"sidewinding\"\nbend = 14\n";
    CHECK(Read(body + "lift = 14\n").fault().empty());
    CHECK_FALSE(Read(body + "lift = 14\nwave = \"square\"\n").fault().empty());
    CHECK_FALSE(Read(body + "lift = 14.5\n").fault().empty());
    CHECK_FALSE(Read(body + "lift = 14\nseek.point = [1, 0, 0]\n").fault().empty());
}

TEST_CASE("what does not go together is refused where the scene says it", "[unit]") {
    struct Case {
        const char* name;
        const char* table;
        const char* sentence;
        bool on_surface = false;
    };
    const Case cases[] = {
        {"short waves", "segments = 10\nwaves = 2.6\n",
         "scene.toml:2:9: waves are shorter than 4 segments; expected at most 2.5 of them in 10 segments"},
        {"short waves of few segments", "segments = 3\nwaves = 1\n", "expected at most 0.75 of them"},
        {"two goals", "seek.point = [1, 0, 0]\nfollow_path.points = [[0, 0, 0], [1, 0, 0]]\n",
         "scene.toml:1:14: they are to go to a point and along a path at once"},
        {"a drop without an edge", "cliff.drop = 0.1\n", "scene.toml:1:14: a cliff has no edge"},
        {"a radius without an edge", "cliff.radius = 0.01\n", "scene.toml:1:16: a cliff has no edge"},
        {"a wide edge", "cliff = { edge = 0, radius = 0.03, drop = 0.05 }\n",
         "scene.toml:1:30: the rounded edge is higher than half of the cliff"},
        {"bends that fold", "length = 0.1\nwidth = 0.01\nbend = 20\ngait = \"undulation\"\n",
         "scene.toml:3:8: muscles would fold over what is inside of bends; expected bends and turns of less "
         "than 20 together, as curvatures over one length; ask for"},
        {"lifts that fold",
         "length = 0.1\nwidth = 0.01\nlift = 14.5\nstrain = 0.2\ngait = \"caterpillar\"\nwaves = 1\n",
         "expected bends and turns of less than 14.3 together, as curvatures over one length, where segments "
         "shorten by 0.2"},
        {"a strain that folds turns",
         "length = 0.1\nwidth = 0.01\nstrain = 0.9\nturn = 1\nseek.point = [1, 0, 0]\n",
         "scene.toml:4:8: muscles would fold over"},
        {"a floor beside a surface", "floor = 0\n", "scene.toml:1:9: there are two grounds to crawl on", true},
        {"a cliff beside a surface", "cliff.edge = 0\n", "scene.toml:1:14: there are two grounds", true},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        const Read read(each.table, each.on_surface ? &floor_land().surface() : nullptr);
        CHECK_THAT(read.fault(), Catch::StartsWith(each.sentence) || Catch::Contains(each.sentence));
        CHECK(read.faults.size() == 1);
    }
}

TEST_CASE("waves of exactly four segments, and an edge of half the drop, are taken", "[unit]") {
    CHECK(Read("segments = 10\nwaves = 2.5\n").fault().empty());
    CHECK(Read("cliff = { edge = 0, radius = 0.025, drop = 0.05 }\n").fault().empty());
}

TEST_CASE("method, step, solver and what to do with unstable steps reach the simulation", "[unit]") {
    using namespace mass_spring;
    const Read plain(kSmall);
    CHECK(plain.crawler.settings.method->name == std::string("symplectic_euler"));
    CHECK(plain.crawler.settings.step == 0);
    CHECK(plain.crawler.settings.on_unstable == OnUnstable::substep);
    CHECK(plain.crawler.linear_solver == LinearSolverKind::automatic);
    const Read told(std::string(kSmall) +
                    "method = \"tr_bdf2\"\nstep = \"2 ms\"\non_unstable = \"as_asked\"\nmax_substeps = 7\n"
                    "linear_solver = \"cholesky\"\n");
    CHECK(told.crawler.settings.method == find_method("tr_bdf2"));
    CHECK(told.crawler.settings.step == 0.002);
    CHECK(told.crawler.settings.on_unstable == OnUnstable::as_asked);
    CHECK(told.crawler.settings.max_substeps == 7);
    CHECK(told.crawler.linear_solver == LinearSolverKind::cholesky);
    CHECK(Read(std::string(kSmall) + "on_unstable = \"stop\"\n").crawler.settings.on_unstable ==
          OnUnstable::stop);
    CHECK(Read(std::string(kSmall) + "linear_solver = \"conjugate_gradients\"\n").crawler.linear_solver ==
          LinearSolverKind::conjugate_gradients);
}
