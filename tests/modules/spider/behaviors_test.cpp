#include "behaviors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "walker.hpp"

using namespace walker;
using land::Land;

namespace {

/// Some creatures that a test puts where it likes.
struct Group final : Creatures {
    std::vector<Vec3> places, speeds;
    std::string_view name() const noexcept override { return "group"; }
    std::span<const Vec3> positions() const noexcept override { return places; }
    std::span<const Vec3> velocities() const noexcept override { return speeds; }
};

Behaviors::Goal goal(const Land& land, const Vec3& point) {
    return {WayField(land.surface(), spot(land, point)), 1};
}

}  // namespace

TEST_CASE("who is to arrive stops there, on level land and on a plateau above an overhang", "[unit]") {
    struct Case {
        mesh::RawMesh mesh;
        Vec3 from, to;
        double seconds;
    };
    for (const Case& c : {Case{mesh::cube(2, 4), {-0.3, 1, 0.1}, {0.2, 1, -0.3}, 9},
                          Case{mesh::cliff(0.7, 8), {-0.25, 0, 0.1}, {0.1, 0.35, -0.1}, 16}}) {
        const Land land(c.mesh);
        Conduct conduct = purposeful();
        conduct.behaviors.arrive = goal(land, c.to);
        conduct.behaviors.slowing = 0.05;
        Walker walker(land, conduct, c.from, {0, 1, 0}, {1, 0, 0});
        walker.walk(c.seconds);
        // It comes nearer by a factor of e each 0.05 / 0.15 s.
        CHECK(distance(walker.position(), c.to) < 1e-4);
        CHECK(walker.speed() < 1e-3);
        CHECK(walker.measures.lost_frames == 0);
    }
}

TEST_CASE("who arrives on an edge of the mesh stands there, as still as elsewhere", "[unit]") {
    const Land land(mesh::cube(0.4, 1));
    for (const Vec3 to : {Vec3{0.05, 0.2, 0.05}, Vec3{0.2, 0.2, 0}}) {
        Conduct conduct = purposeful();
        conduct.behaviors.arrive = goal(land, to);
        conduct.behaviors.slowing = 0.05;
        Walker walker(land, conduct, {-0.1, 0.2, 0.12}, {0, 1, 0}, {1, 0, 0});
        walker.walk(22);
        const Vec3 place = pose_of(walker.conduct, walker.state).position;
        CHECK(distance(walker.position(), to) < 1e-6);
        walker.walk(5);
        CHECK(distance(pose_of(walker.conduct, walker.state).position, place) < 1e-6);
    }
}

TEST_CASE("who seeks comes by, at full speed", "[unit]") {
    const Land land(mesh::cube(2, 4));
    Conduct conduct = purposeful();
    conduct.behaviors.seek = goal(land, {0.4, 1, 0});
    Walker walker(land, conduct, {-0.2, 1, 0}, {0, 1, 0}, {1, 0, 0});
    double nearest = 1, fastest = 0;
    for (int i = 0; i < 5 * 60; ++i) {
        walker.step();
        nearest = std::min(nearest, distance(walker.position(), {0.4, 1, 0}));
        if (nearest < 0.01) fastest = std::max(fastest, walker.speed());
    }
    CHECK(nearest < 0.15 * kFrame);
    CHECK(fastest == Approx(0.15).epsilon(1e-3));
}

TEST_CASE("who flees gets away as fast as it runs, as long as the danger is near", "[unit]") {
    const Land land(mesh::cube(2, 4));
    Conduct conduct = purposeful();
    conduct.behaviors.flee = goal(land, {-0.1, 1, 0});
    conduct.behaviors.flee_within = 0.5;
    Walker walker(land, conduct, {0, 1, 0}, {0, 1, 0}, {1, 0, 0});
    double last = 0.1;
    for (int second = 1; second <= 2; ++second) {
        walker.walk(1);
        const double off = distance(walker.position(), {-0.1, 1, 0});
        CHECK(off > last);
        last = off;
    }
    CHECK(last == Approx(0.1 + 0.15 * 2).margin(0.15 * 0.15 + 0.01));  // it starts within 0.15 s
    Walker far(land, conduct, {0.5, 1, 0}, {0, 1, 0}, {1, 0, 0});
    far.walk(1);
    CHECK(distance(far.position(), {0.5, 1, 0}) == 0);
}

TEST_CASE("a hunter catches a quarry that goes straight on when it was to be foreseen", "[unit]") {
    const Land land(mesh::cube(2, 4));
    Conduct conduct = purposeful();
    conduct.behaviors.pursue = 1;
    const Vec3 velocity{0, 0, 0.08};
    Agent quarry{{0.4, 1, 0}, velocity, {0, 1, 0}, 0.08};
    const double predicted = 0.4 / std::sqrt(0.15 * 0.15 - 0.08 * 0.08);
    Walker hunter(land, conduct, {0, 1, 0}, {0, 1, 0}, {std::sqrt(0.15 * 0.15 - 0.08 * 0.08), 0, 0.08});
    double caught = 0;
    for (int i = 1; i < 6 * 60 && caught == 0; ++i) {
        hunter.step({}, quarry);
        quarry.position += kFrame * velocity;
        if (distance(hunter.position(), quarry.position) < 0.005) caught = i * kFrame;
    }
    // It is as late as its start is slow, 0.15 s, and early by the last 5 mm at a closing speed of 0.13 m/s.
    CHECK(caught > predicted);
    CHECK(caught < predicted + 0.2);
}

TEST_CASE("a rest ends where a hunter comes near", "[unit]") {
    const Land land(mesh::cube(2, 4));
    Conduct conduct = purposeful();
    conduct.rests = true;
    conduct.behaviors.evade = 1;
    conduct.behaviors.evade_within = 0.2;
    Walker prey(land, conduct, {0, 1, 0}, {0, 1, 0}, {1, 0, 0});
    const auto hunter_at = [](double x) { return Agent{{x, 1, 0}, {}, {0, 1, 0}, 0.1}; };
    prey.state.pause = {true, 10, 0, 1};
    for (int i = 0; i < 60; ++i) prey.step({}, {}, hunter_at(-0.3));
    CHECK(prey.position().x == 0);
    for (int i = 0; i < 60; ++i) prey.step({}, {}, hunter_at(prey.position().x - 0.1));
    CHECK(prey.state.pause.stands);
    CHECK(prey.position().x == Approx(0.15 - 0.15 * (0.15 - kFrame)).margin(1e-3));
}

TEST_CASE("a path over hills is followed within a corridor, round and round", "[unit]") {
    const Land land(mesh::height_field(0.8, 32));
    const std::vector<Vec3> corners{{-0.2, 0, 0.2}, {0.2, 0, 0.2}, {0.2, 0, -0.2}, {-0.2, 0, -0.2}};
    Conduct conduct = purposeful();
    conduct.behaviors.follow_path = 1;
    conduct.behaviors.loop = true;
    conduct.behaviors.path_ahead = 0.03;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto way =
            shortest_way(land.surface(), spot(land, corners[i]), spot(land, corners[(i + 1) % 4]), 0.01);
        conduct.behaviors.path.insert(conduct.behaviors.path.end(), way.begin(), way.end() - 1);
    }
    Walker walker(land, conduct, {-0.2, 0, 0.2}, {0, 1, 0}, {1, 0, 0});
    constexpr double kCorridor = 0.035;  // m; at 0.15 m/s and 110 degrees a second it turns about 0.08 m
    double farthest = 0;
    std::vector<bool> passed(conduct.behaviors.path.size());
    for (int i = 0; i < 20 * 60; ++i) {
        walker.step();
        double off = 1;
        for (std::size_t k = 0; k < passed.size(); ++k) {
            const double here = distance(conduct.behaviors.path[k], walker.position());
            if (here < kCorridor) passed[k] = true;
            off = std::min(off, here);
        }
        farthest = std::max(farthest, off);
    }
    CHECK(farthest < kCorridor);
    CHECK(std::count(passed.begin(), passed.end(), false) == 0);
}

TEST_CASE("wishes of all behaviors are weighed together", "[unit]") {
    const Land land(mesh::cube(2, 4));
    const Agent agent{{0, 1, 0}, {}, {0, 1, 0}, 0.1};
    const RandomStream random(1, "wishes");
    Behaviors behaviors;
    behaviors.wander = 2;
    behaviors.seek = goal(land, {0.5, 1, 0});
    behaviors.avoid_obstacles = 0;
    Company company{random, {}};
    const Vec3 both = combined(behaviors, agent, spot(land, {0, 1, 0}), company, {0, 0, 0.1}, {});
    CHECK(both.x == Approx(0.1 / 3));
    CHECK(both.z == Approx(0.2 / 3));
    // A hunter counts only where it is feared, and near.
    company.hunter = Agent{{-0.3, 1, 0}, {}, {0, 1, 0}, 0.1};
    CHECK(combined(behaviors, agent, spot(land, {0, 1, 0}), company, {0, 0, 0.1}, {}) == both);
    behaviors.evade = 1;
    behaviors.evade_within = 0.2;
    CHECK(combined(behaviors, agent, spot(land, {0, 1, 0}), company, {0, 0, 0.1}, {}) == both);
    behaviors.evade_within = 0.4;
    CHECK(combined(behaviors, agent, spot(land, {0, 1, 0}), company, {0, 0, 0.1}, {}).x == Approx(0.2 / 4));
}

TEST_CASE("the nearest of a group is never oneself", "[unit]") {
    Group group;
    CHECK_FALSE(nearest_of(group, {}, 0));
    group.places = {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}};
    group.speeds = {{}, {}, {0, 0, 7}};
    CHECK(nearest_of(group, {0.1, 0, 0}, SIZE_MAX)->position == Vec3{});
    CHECK(nearest_of(group, {0.1, 0, 0}, 0)->position == Vec3{1, 0, 0});
    CHECK(nearest_of(group, {0.1, 0, 0}, 0)->velocity == Vec3{0, 0, 7});
    group.places.resize(1);
    CHECK_FALSE(nearest_of(group, {}, 0));
}

TEST_CASE("who does not look for the ground's up keeps the one that it last wanted", "[unit]") {
    const Land land(mesh::sphere(1, 8));
    const auto up_after = [&](bool orients) {
        Walker walker(land, purposeful(), {0, 0.5, 0}, {0, 1, 0}, {1, 0, 0});
        for (int i = 0; i < 60; ++i) {
            Company company{walker.random, {}};
            company.command = Command{0.1, 0};
            company.orients = orients;
            advance_creature(land.surface(), walker.conduct, company, kFrame, walker.state, walker.measures);
        }
        return walker.state.turn.up;
    };
    CHECK(up_after(false) == land.stand({0, 0.5, 0}, {0, 1, 0}, {1, 0, 0}).up);
    CHECK(up_after(true).x == Approx(0.2).margin(0.05));  // 0.1 m on a ball of 0.5 m
}
