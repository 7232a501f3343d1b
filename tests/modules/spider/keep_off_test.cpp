#include "keep_off.hpp"

#include <cmath>

#include "creatures.hpp"
#include "land.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

/// Level, above a place, looking along `forward`.
BodyPose above(const Footing& ground, const Vec3& forward, double height) {
    return {ground.position + height * ground.up, forward, ground.up, cross(forward, ground.up)};
}

/// Along the ground, as high as a huntsman is carried.
BodyPose pose_above(const Footing& ground) { return above(ground, ground.forward, 0.011); }

BodyPose moved(BodyPose pose, const Vec3& by) {
    pose.position += by;
    return pose;
}

/// Points of the body's ellipsoids, which know nothing of balls.
template <class Each>
void each_point(const Body& body, const BodyPose& pose, const Each& each) {
    const double front = body.thorax.x / 2;
    const std::pair<Vec3, double> parts[] = {
        {body.thorax, 0}, {body.head, front + body.head.x / 2}, {body.abdomen, -front - body.abdomen.x / 2}};
    for (const auto& [extents, middle] : parts)
        for (int latitude = -90; latitude <= 90; latitude += 10)
            for (int longitude = 0; longitude < 360; longitude += 10) {
                const double a = latitude * kDegree, b = longitude * kDegree;
                each(to_world(pose, {middle + extents.x / 2 * std::cos(a) * std::cos(b),
                                     extents.y / 2 * std::sin(a), extents.z / 2 * std::cos(a) * std::sin(b)}));
            }
}

/// m, how deep the deepest of them is inside a cube about the origin.
double depth_in_cube(const Body& body, const BodyPose& pose, double half) {
    double deepest = -HUGE_VAL;
    each_point(body, pose, [&](const Vec3& p) {
        deepest = std::max(deepest, half - std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
    });
    return deepest;
}

}  // namespace

TEST_CASE("over level ground a body is as deep as its lowest ball", "[unit]") {
    const Land cube(mesh::cube(1, 4));
    const Species huntsman = creature("huntsman");
    const Footing ground = cube.stand({0.03, 0.5, 0.02}, {0, 1, 0}, {1, 0, 0});
    const double lowest = depth_of(huntsman.shape);
    for (const double height : {0.0011, 0.002, 0.0028}) {
        const BodyPose pose = above(ground, {1, 0, 0}, height);
        CHECK(penetration(cube.surface(), huntsman.shape, ground, pose) ==
              Approx(lowest - height).epsilon(1e-9));
        CHECK(lowest - height >= depth_in_cube(huntsman.body, pose, 0.5));
    }
    CHECK(penetration(cube.surface(), huntsman.shape, ground, above(ground, {1, 0, 0}, lowest * 1.001)) == 0);
    CHECK(penetration(cube.surface(), huntsman.shape, ground, above(ground, {1, 0, 0}, 0.01)) == 0);
}

TEST_CASE("an abdomen that hangs into a wall is found, and so is a body behind one", "[unit]") {
    const Land room(mesh::room(1, 4));
    const Species huntsman = creature("huntsman");
    const Footing ground = room.stand({0.47, -0.5, 0}, {0, 1, 0}, {1, 0, 0});
    // Looking away from the wall, which is 30 mm off, it ends 16.5 mm behind its middle: clear. 20 mm nearer
    // not.
    const BodyPose pose = above(ground, {-1, 0, 0}, 0.011);
    CHECK(penetration(room.surface(), huntsman.shape, ground, pose) == 0);
    const double deep = penetration(room.surface(), huntsman.shape, ground, moved(pose, {0.02, 0, 0}));
    CHECK(deep > 0.0065);
    CHECK(deep < 0.0073);  // the balls' growth included
    CHECK(penetration(room.surface(), huntsman.shape, ground, moved(pose, {0.04, 0, 0})) > 0.01);
}

TEST_CASE("a body is pushed off walls, out of corners and over edges, and no more than it takes", "[unit]") {
    const Species huntsman = creature("huntsman");
    const Land room(mesh::room(1, 4)), cube(mesh::cube(1, 4));
    const Footing corner = room.stand({0.497, -0.5, 0.496}, {0, 1, 0}, {1, 0, 0});
    Vec3 shift;
    const BodyPose into = above(corner, Vec3{0.6, 0, 0.8}, 0.011);
    REQUIRE(penetration(room.surface(), huntsman.shape, corner, into) > 0.003);
    CHECK(keep_off(room.surface(), huntsman.shape, corner, into, 0.04, shift) == 0);
    CHECK(penetration(room.surface(), huntsman.shape, corner, moved(into, shift)) == 0);
    CHECK(norm(shift) < 0.015);
    each_point(huntsman.body, moved(into, shift), [&](const Vec3& p) {
        CHECK(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 0.5);
    });
    const Footing rim = cube.stand({0.499, 0.5, 0}, {0, 1, 0}, {1, 0, 0});
    const Vec3 down = Vec3{0.6, -0.8, 0}, up{0.8, 0.6, 0};
    const BodyPose over{rim.position + 0.0015 * up, down, up, cross(down, up)};
    REQUIRE(depth_in_cube(huntsman.body, over, 0.5) > 0);
    shift = {};
    CHECK(keep_off(cube.surface(), huntsman.shape, rim, over, 0.04, shift) == 0);
    CHECK(depth_in_cube(huntsman.body, moved(over, shift), 0.5) <= 0);
    CHECK(norm(shift) < 0.01);
}

TEST_CASE("a bent abdomen counts where it is", "[unit]") {
    const Land cube(mesh::cube(1, 4));
    const Species huntsman = creature("huntsman");
    const Footing ground = cube.stand({0.03, 0.5, 0.02}, {0, 1, 0}, {1, 0, 0});
    BodyPose pose = above(ground, {1, 0, 0}, 0.004);
    CHECK(penetration(cube.surface(), huntsman.shape, ground, pose) == 0);
    pose.bend = 0.8;  // raised
    CHECK(penetration(cube.surface(), huntsman.shape, ground, pose) == 0);
    pose.bend = -0.8;
    const Vec3 half = 0.5 * huntsman.body.abdomen;
    const double lowest =  // of the bent ellipsoid below the thorax's middle
        half.x * std::sin(0.8) + std::hypot(half.x * std::sin(0.8), half.y * std::cos(0.8));
    const double deep = penetration(cube.surface(), huntsman.shape, ground, pose);
    CHECK(deep >= lowest - 0.004);
    CHECK(deep <= lowest - 0.004 + 0.36 * half.y);  // the balls' growth
    Vec3 shift;
    CHECK(keep_off(cube.surface(), huntsman.shape, ground, pose, 0.04, shift) == 0);
    CHECK(dot(shift, ground.up) >= lowest - 0.004);
}

TEST_CASE("where a body has no room the penetration that is left is told", "[unit]") {
    const Land tube(mesh::room(0.008, 2));  // 8 mm wide: an abdomen is 12 mm long
    const Species huntsman = creature("huntsman");
    const Footing ground = tube.stand({0, -0.004, 0}, {0, 1, 0}, {1, 0, 0});
    Vec3 shift;
    CHECK(keep_off(tube.surface(), huntsman.shape, ground, above(ground, {1, 0, 0}, 0.004), 0.04, shift) >
          0.001);
    CHECK(norm(shift) <= 0.04 * (1 + 1e-12));
}

TEST_CASE("in a crease sharper than a right angle a body is on the side on which its creature stands",
          "[unit]") {
    const Land cliff(mesh::cliff(1, 4));  // y = 0 where x < 0, and a wall that leans out over it: x = -y / 2
    const Species huntsman = creature("huntsman");
    const Vec3 wall_up = Vec3{-2, -1, 0} / std::sqrt(5.0);
    for (const double off : {1e-3, 1e-5, 1e-7, 1e-12}) {
        INFO(off);
        const Footing below = cliff.stand({-off, 0, 0.03}, {0, 1, 0}, {0, 0, 1});
        const Footing above = cliff.stand({-off, 2 * off, 0.03}, wall_up, {0, 0, 1});
        for (const Footing& ground : {below, above}) {
            const BodyPose beyond = pose_above(ground);
            CHECK(penetration(cliff.surface(), huntsman.shape, ground, beyond) > 0.004);
            Vec3 shift;
            CHECK(keep_off(cliff.surface(), huntsman.shape, ground, beyond, 0.04, shift) == 0);
            const Vec3 p = beyond.position + shift;
            CHECK(p.y > 0);
            CHECK(p.x < -p.y / 2);
        }
    }
}

TEST_CASE("a body comes out of a valley as narrow as itself", "[unit]") {
    const Species tarantula = creature("tarantula");
    mesh::RawMesh valley;  // of two walls, 20 degrees from upright
    const double out = std::tan(20 * kDegree);
    valley.points = {{-out, 1, -1}, {0, 0, -1}, {out, 1, -1}, {-out, 1, 1}, {0, 0, 1}, {out, 1, 1}};
    valley.material_names = {"rock"};
    valley.add_polygon({0, 3, 4, 1});
    valley.add_polygon({1, 4, 5, 2});
    const Land land(valley);
    const Footing ground = land.stand({0.002, 0.002 / out, 0}, {-1, 0, 0}, {0, 0, 1});
    const Vec3 up{0, 1, 0}, forward{1, 0, 0};  // across it
    Vec3 shift;
    const BodyPose low{ground.position + 0.01 * up, forward, up, cross(forward, up)};
    CHECK(keep_off(land.surface(), tarantula.shape, ground, low, 0.2, shift) == 0);
    CHECK(penetration(land.surface(), tarantula.shape, ground, moved(low, shift)) == 0);
}
