#include "ground.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "land.hpp"
#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using land::Land;

namespace {

Ground standing(const Land& land, const Vec3& position, const Vec3& up, const Vec3& forward, double speed) {
    Ground ground;
    ground.footing = land.stand(position, up, forward);
    ground.velocity = speed * ground.footing.forward;
    ground.facing = ground.footing.forward;
    return ground;
}

}  // namespace

TEST_CASE("a creature walks straight over a cube's edges and comes back, its head where it was", "[unit]") {
    const Land cube(mesh::cube(2, 3));
    Ground ground = standing(cube, {0.21, 0.13, 1}, {0, 0, 1}, {1, 0, 0}, 0.4);
    const Ground begin = ground;
    for (int i = 0; i < 1200; ++i)
        CHECK(move(cube.surface(), 1.0 / 60, 0.01, ground.velocity, ground) == MoveEnd::moved);
    CHECK(distance(ground.footing.position, begin.footing.position) < 1e-12);
    CHECK(distance(ground.facing, begin.facing) < 1e-12);
    CHECK(norm(ground.velocity) == Approx(0.4).epsilon(1e-12));
}

TEST_CASE("a head that looks aside looks as far aside behind an edge", "[unit]") {
    const Land cube(mesh::cube(2, 3));
    Ground ground = standing(cube, {0.9, 0.13, 1}, {0, 0, 1}, {1, 0, 0}, 0.4);
    ground.facing = {0.6, 0.8, 0};
    move(cube.surface(), 0.5, 0.01, ground.velocity, ground);  // 0.1 m to the edge, 0.1 m down the side
    CHECK(distance(ground.footing.position, {1, 0.13, 0.9}) < 1e-12);
    CHECK(distance(ground.facing, {0, 0.8, -0.6}) < 1e-12);
    CHECK(distance(ground.velocity, {0, 0, -0.4}) < 1e-12);
}

TEST_CASE("a border turns a creature back, and it is not lost", "[unit]") {
    const Land strip(mesh::height_field(1, 4));
    const RandomStream random(2, "borders");
    Ground ground = standing(strip, {0, 1, 0}, {0, 1, 0}, {1, 0, 0.3}, 0.3);
    int turned = 0;
    for (std::uint64_t i = 0; i < 6000; ++i) {
        const MoveEnd end = move(strip.surface(), 1.0 / 60, 0.01, ground.velocity, ground);
        REQUIRE(end != MoveEnd::lost);
        if (end == MoveEnd::turned) ++turned;
        const Vec3 aside = cross(ground.footing.up, ground.footing.forward);
        if (i % 97 == 0) ground.velocity += random.uniform(i, -0.2, 0.2) * aside;
        CHECK(std::abs(dot(ground.velocity, ground.footing.up)) < 1e-12);
    }
    CHECK(turned > 10);
}

TEST_CASE("a head turns towards the way at its rate, right about too", "[unit]") {
    const Land floor(mesh::height_field(1, 4));
    for (const double degrees : {10.0, 90.0, 180.0, -120.0}) {
        Ground ground = standing(floor, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, 0.3);
        const Vec3 ahead = ground.footing.forward, left = cross(ground.footing.up, ahead);
        const double angle = degrees * M_PI / 180;
        ground.velocity = 0.3 * (std::cos(angle) * ahead + std::sin(angle) * left);
        int turns = 0;
        while (dot(ground.facing, ground.velocity) < 0.3 * (1 - 1e-12) && turns < 1000) {
            const Vec3 before = ground.facing;
            face_ahead(3, ground);
            const double turn = std::atan2(norm(cross(before, ground.facing)), dot(before, ground.facing));
            CHECK(turn <= 3 * M_PI / 180 * (1 + 1e-9));
            ++turns;
        }
        CHECK(turns == Approx(std::abs(degrees) / 3).margin(1.01));
    }
}

TEST_CASE("a wall is felt before the creature arrives, and an edge too", "[unit]") {
    const Land room(mesh::room(2, 4)), cube(mesh::cube(2, 4));
    const Ground inside = standing(room, {0.8, -1, 0.1}, {0, 1, 0}, {1, 0, 0.2}, 0.3);
    const Feel wall = feel_ahead(room.surface(), inside, 0.4, 0.01);
    CHECK(wall.rises);
    CHECK(wall.corner_degrees == Approx(90).margin(0.001));
    CHECK(wall.corner_distance == Approx(0.2 * norm(Vec3{1, 0, 0.2})).epsilon(1e-9));
    CHECK(distance(wall.corner_along, {0, 0, 1}) < 1e-12);
    const double share = 1 / std::sqrt(5.0);  // two ups of the floor, one of the wall
    CHECK(distance(wall.up, {-share, 2 * share, 0}) < 1e-12);
    const Ground outside = standing(cube, {0.8, 1, 0.1}, {0, 1, 0}, {1, 0, 0}, 0.3);
    const Feel edge = feel_ahead(cube.surface(), outside, 0.4, 0.01);
    CHECK_FALSE(edge.rises);
    CHECK(distance(edge.up, {share, 2 * share, 0}) < 1e-12);
    const Feel level = feel_ahead(cube.surface(), outside, 0.1, 0.01);
    CHECK(level.corner_distance > 0.1);
    CHECK(level.up == Vec3{0, 1, 0});
}

TEST_CASE("the end of the surface is felt ahead, and the side that has more room", "[unit]") {
    const Land strip(mesh::height_field(1, 4));
    const Ground towards = standing(strip, {0.45, 0.02, 0.3}, {0, 1, 0}, {1, 0, 0}, 0.1);
    const Feel border = feel_ahead(strip.surface(), towards, 0.1, 0.01);
    CHECK(border.border_distance > 0.04);
    CHECK(border.border_distance < 0.08);  // hills are longer than they are wide
    // Half left of +x is towards -z, where there is room; half right is the nearer corner.
    CHECK(border.room_left >= border.room_right);
    const Feel far = feel_ahead(strip.surface(), towards, 0.03, 0.01);
    CHECK(far.border_distance > 0.03);
    const Land crevice(mesh::room(0.05, 2));
    const Ground below = standing(crevice, {0, -0.025, 0}, {0, 1, 0}, {1, 0, 0}, 0.1);
    CHECK(feel_ahead(crevice.surface(), below, 0.01, 0.049).border_distance > 0.01);
    CHECK(feel_ahead(crevice.surface(), below, 0.01, 0.051).border_distance < 0.01);  // the ceiling is too low
}

TEST_CASE("a crate on a floor is climbed, and nobody goes to where there is no room", "[unit]") {
    const Land land(land::crates_on_a_floor());
    Ground ground = standing(land, {0.05, 0, 0.1}, {0, 1, 0}, {1, 0, 0}, 0.3);
    for (int i = 0; i < 60; ++i)
        CHECK(move(land.surface(), 1.0 / 60, 0.01, ground.velocity, ground) == MoveEnd::moved);
    // 0.075 m of floor, 0.135 of wall, and 0.09 of the crate's top.
    CHECK(distance(ground.footing.position, {0.215, 0.135, 0.1}) <
          1e-6);  // shells are felt a ten-millionth off
    CHECK(distance(ground.facing, {1, 0, 0}) < 1e-12);
    const Land shelf(land::together(mesh::cube(1, 2), mesh::transformed(mesh::cube(0.3, 2), 1, {0, 0.75, 0})));
    Ground below = standing(shelf, {0, 0.5, 0.3}, {0, 1, 0}, {0, 0, -1}, 0.1);
    int turned = 0;
    for (int i = 0; i < 240; ++i)
        if (move(shelf.surface(), 1.0 / 60, 0.12, below.velocity, below) == MoveEnd::turned) ++turned;
    CHECK(turned > 0);
    CHECK(below.footing.position.z > 0.15);  // it hangs 0.1 m above the cube
}
