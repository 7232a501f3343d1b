#include "surface_ground.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "orbweaver/random.hpp"
#include "spider/land.hpp"
#include "tbb_workers.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;
using land::Land;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What one point that has looked is told there.
Touch look(const Land& land, const Vec3& x, const Vec3& v = {}, double time = 0.01, double near = 0.1) {
    SurfaceGround ground(land.surface(), 1, near, nullptr);
    ground.look({&x, 1}, {&v, 1}, time);
    return ground.touch(x, 0);
}

/// Signed, m, outside above 0: of a cube about the origin.
double distance_to_cube(const Vec3& p, double size) {
    const Vec3 q{std::abs(p.x) - size / 2, std::abs(p.y) - size / 2, std::abs(p.z) - size / 2};
    const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return norm(out) + std::min(0.0, std::max({q.x, q.y, q.z}));
}

}  // namespace

TEST_CASE("a level face is a floor", "[unit]") {
    const Land land(land::crates_on_a_floor());
    const RandomStream random(2, "level");
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Vec3 p{random.uniform(3 * i, 0.3, 0.49), random.uniform(3 * i + 1, -0.05, 0.05),
                     random.uniform(3 * i + 2, -0.49, -0.1)};
        const Touch touch = look(land, p);
        CHECK(touch.depth == Approx(-p.y).margin(1e-12));
        CHECK(distance(touch.normal, {0, 1, 0}) < 1e-12);
    }
}

TEST_CASE("a cube is as far as it is, in front of its faces, edges and corners, and within", "[unit]") {
    const Land land(mesh::cube(2, 3));
    const RandomStream random(6, "cube");
    int within = 0, beside = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Vec3 p{random.uniform(3 * i, -1.09, 1.09), random.uniform(3 * i + 1, -1.09, 1.09),
                     random.uniform(3 * i + 2, -1.09, 1.09)};
        const double far = distance_to_cube(p, 2);
        if (std::abs(far) > 0.0999) continue;
        const Touch touch = look(land, p);
        CHECK(touch.depth == Approx(-far).margin(1e-9));
        // It leads onto the surface by the way it says.
        CHECK(std::abs(distance_to_cube(p + touch.depth * touch.normal, 2)) < 1e-9);
        CHECK(norm(touch.normal) == Approx(1).epsilon(1e-12));
        if (far < 0) ++within;
        if (std::max({std::abs(touch.normal.x), std::abs(touch.normal.y), std::abs(touch.normal.z)}) < 0.99)
            ++beside;
    }
    CHECK(within > 100);
    CHECK(beside > 20);
}

TEST_CASE("where no surface is near there is nothing to meet, however far a point falls", "[unit]") {
    const Land land(mesh::cube(2, 3));
    const Vec3 x{0, 1.2, 0};
    SurfaceGround ground(land.surface(), 1, 0.1, nullptr);
    CHECK(look(land, x).depth == -kInfinity);
    CHECK(look(land, x, {0, 3, 0}).depth == -kInfinity);  // away
    const Vec3 v;
    ground.look({&x, 1}, {&v, 1}, 0.01);
    CHECK(ground.touch({0, -5, 0}, 0).depth == -kInfinity);
    // At 0.1 m and a little less it is near.
    CHECK(look(land, {0, 1.0999, 0}).depth == Approx(-0.0999).epsilon(1e-9));
    // What moves gets farther than it looks around at rest.
    CHECK(look(land, x, {9, 0, 0}, 0.01).depth == -kInfinity);
    CHECK(look(land, x, {11, 0, 0}, 0.01).depth == Approx(-0.2).epsilon(1e-9));
}

TEST_CASE("who flies fast meets what is ahead, although something else is nearer", "[unit]") {
    const Land room(mesh::room(2, 3));
    const Vec3 x{-0.5, -0.95, 0.1};
    const Touch still = look(room, x);
    CHECK(still.depth == Approx(-0.05).epsilon(1e-9));
    CHECK(distance(still.normal, {0, 1, 0}) < 1e-12);
    // 1.5 m to the wall: within two frames' way.
    const Touch flying = look(room, x, {80, 0, 0});
    CHECK(flying.depth == Approx(-1.5).epsilon(1e-9));
    CHECK(distance(flying.normal, {-1, 0, 0}) < 1e-12);
    // A frame takes it 0.6 m: the wall is met in a later one.
    CHECK(look(room, x, {60, 0, 0}).depth == Approx(-0.05).epsilon(1e-9));
    // Whatever side it comes from: no way through.
    const Land cube(mesh::cube(2, 3));
    const Touch outwards = look(cube, {0.95, 0.2, 0.1}, {50, 0, 0});
    CHECK(outwards.depth == Approx(-0.05).epsilon(1e-9));
    CHECK(distance(outwards.normal, {-1, 0, 0}) < 1e-12);
    const Touch inwards = look(cube, {1.4, 0.2, 0.1}, {-50, 0, 0});
    CHECK(inwards.depth == Approx(-0.4).epsilon(1e-9));
    CHECK(distance(inwards.normal, {1, 0, 0}) < 1e-12);
}

TEST_CASE("planes stay as they were when points looked last, each point its own", "[unit]") {
    const Land land(mesh::cube(2, 3));
    SurfaceGround ground(land.surface(), 2, 0.1, nullptr);
    Vec3 x[] = {{0, 1.05, 0.2}, {-0.98, 0.2, 0}};
    const Vec3 v[2];
    ground.look(x, v, 0.01);
    const Vec3 p{1.5, 0.7, 0.2};
    for (int round = 0; round < 2; ++round) {
        CHECK(ground.touch(p, 0).depth == Approx(0.3).epsilon(1e-9));
        CHECK(ground.touch(p, 1).depth == Approx(2.5).epsilon(1e-9));
        x[0] = {1.01, 0.2, 0};  // moved, but it has not looked
    }
    ground.look(x, v, 0.01);
    CHECK(ground.touch(p, 0).depth == Approx(-0.5).epsilon(1e-9));
    CHECK(ground.touch(p, 1).depth == Approx(2.5).epsilon(1e-9));
}

TEST_CASE("a face grips a body by its friction, 0.6 being usual, and a place without one usually", "[unit]") {
    surface::GripOverrides grips;
    grips.all.friction = 0.3;
    grips.patches = {{0.9, {}}};
    // The quads of the side that holds the first: 2 by 2 of them.
    grips.patched = {{0, 3, 0}};
    const Land land(mesh::cube(2, 2), grips);
    const Vec3 special = land.surface().normal(0);
    CHECK(look(land, 1.01 * special).grip == Approx(1.5).epsilon(1e-12));
    CHECK(look(land, -1.01 * special).grip == Approx(0.5).epsilon(1e-12));
    CHECK(look(land, 1.5 * special).grip == 1);
    CHECK(look(land, 1.5 * special, -100 * special).grip == Approx(1.5).epsilon(1e-12));  // flown towards
}

TEST_CASE("planes are the same to the bit with one thread and with several", "[unit]") {
    const Land land(land::crates_on_a_floor());
    const RandomStream random(9, "threads");
    std::vector<Vec3> x(1000), v(1000);
    for (std::uint64_t i = 0; i < x.size(); ++i) {
        x[i] = {random.uniform(6 * i, -0.4, 0.4), random.uniform(6 * i + 1, 0, 0.2),
                random.uniform(6 * i + 2, -0.4, 0.4)};
        v[i] = {random.uniform(6 * i + 3, -5, 5), random.uniform(6 * i + 4, -5, 5),
                random.uniform(6 * i + 5, -5, 5)};
    }
    workers::TbbWorkers threads(3);
    SurfaceGround alone(land.surface(), x.size(), 0.03, nullptr),
        shared(land.surface(), x.size(), 0.03, &threads);
    alone.look(x, v, 0.01);
    shared.look(x, v, 0.01);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Touch a = alone.touch(x[i], i), b = shared.touch(x[i], i);
        CHECK(std::memcmp(&a, &b, sizeof a) == 0);
    }
}
