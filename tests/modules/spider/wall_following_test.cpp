#include "wall_following.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "walker.hpp"

using namespace walker;
using land::Land;

namespace {

Conduct along_walls(double climb) {
    Conduct conduct = purposeful();
    conduct.behaviors.follow_wall = 1;
    conduct.behaviors.walls = {0.05, climb, 5};
    return conduct;
}

}  // namespace

TEST_CASE("a wall is found with its distance, straight to it and not along the way", "[unit]") {
    const Land room(mesh::room(1, 4));
    const Footing ground = room.stand({0.2, -0.5, 0.1}, {0, 1, 0}, {1, 0, 0});
    const Wall wall = find_wall(room.surface(), ground, {0.8, 0, 0.6}, 0.6);
    REQUIRE(wall.found);
    CHECK(wall.distance == Approx(0.3).epsilon(1e-12));
    CHECK(distance(wall.toward, {1, 0, 0}) < 1e-12);
    CHECK(std::abs(wall.along.z) == Approx(1).epsilon(1e-12));
    CHECK_FALSE(find_wall(room.surface(), ground, {1, 0, 0}, 0.25).found);
    const Land cube(mesh::cube(1, 4));
    CHECK_FALSE(
        find_wall(cube.surface(), cube.stand({0.4, 0.5, 0}, {0, 1, 0}, {1, 0, 0}), {1, 0, 0}, 0.2).found);
}

TEST_CASE("who never climbs goes round a room along its walls, at the distance that is asked", "[unit]") {
    const Land room(mesh::room(0.8, 4));
    Walker walker(room, along_walls(0), {0.2, -0.4, 0}, {0, 1, 0}, {1, 0, 0.3});
    walker.walk(0.4, Command{0.15, 0});
    int beside = 0, corners = 0;
    for (int i = 0; i < 40 * 60; ++i) {
        walker.step();
        const Vec3& p = walker.position();
        REQUIRE(p.y == Approx(-0.4).margin(0.01));
        const double nearest = 0.4 - std::max(std::abs(p.x), std::abs(p.z));
        const double other = 0.4 - std::min(std::abs(p.x), std::abs(p.z));
        if (i < 5 * 60) continue;
        if (other < 0.13) {
            ++corners;
        } else {
            ++beside;
            CHECK(nearest == Approx(0.05).margin(0.015));
        }
    }
    CHECK(walker.measures.distance > 35 * 0.12);  // once round is 2.8 m
    CHECK(corners > 60);
    CHECK(beside > 20 * 60);
}

TEST_CASE("who always climbs goes up the first wall", "[unit]") {
    const Land room(mesh::room(0.8, 4));
    Walker walker(room, along_walls(1), {0.2, -0.4, 0}, {0, 1, 0}, {1, 0, 0.3});
    walker.walk(0.3, Command{0.15, 0});
    double highest = -1;
    for (int i = 0; i < 4 * 60; ++i) {
        walker.step();
        highest = std::max(highest, walker.position().y);
    }
    CHECK(highest > -0.2);
}

TEST_CASE("of many who come to a wall as many climb as the chance says", "[unit]") {
    const Land room(mesh::room(0.8, 4));
    const Footing footing = room.stand({0.37, -0.4, 0}, {0, 1, 0}, {1, 0, 0});
    const Ground ground{footing, {0.1, 0, 0}, {1, 0, 0}};
    const Agent agent{footing.position, ground.velocity, footing.up, 0.1};
    int climbing = 0;
    constexpr int kMany = 4000;
    for (int i = 0; i < kMany; ++i) {
        const RandomStream random(static_cast<std::uint64_t>(i), "walls");
        WallState state;
        const Vec3 wish =
            follow_wall(room.surface(), ground, agent, 0.05, {0.05, 0.3, 5}, random, kFrame, state);
        if (state.climbs) ++climbing;
        CHECK((state.climbs ? wish.x : std::abs(wish.z)) > 0.4 * norm(wish));
        CHECK(state.left >= 2.5);
        CHECK(state.left <= 7.5);
    }
    CHECK(climbing == Approx(0.3 * kMany).margin(3.5 * std::sqrt(0.3 * 0.7 * kMany)));
}
