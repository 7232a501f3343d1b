#include "footholds.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "land.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using land::Land;

namespace {

constexpr Vec3 kGravity{0, -9.81, 0};

/// What a leg can use.
struct LegReach {
    Vec3 hip;
    double least, most;  // m, from the hip
};

Foothold find(const Land& land, FootholdWay way, const Footing& ground, const Vec3& wanted, const LegReach& leg,
              double search) {
    return find_foothold(land.surface(), way, ground, {0, 1, 0}, wanted, leg.most, search,
                         [&](const Foothold& hold) {
                             const double stretch = distance(hold.position, leg.hip);
                             return stretch >= leg.least && stretch <= leg.most;
                         });
}

}  // namespace

TEST_CASE("over level land both ways find the same place", "[unit]") {
    const Land cube(mesh::cube(2, 4));
    const Footing ground = cube.stand({0.1, 1, 0.1}, {0, 1, 0}, {1, 0, 0});
    const LegReach leg{{0.1, 1.1, 0.1}, 0.01, 0.5};
    for (const FootholdWay way : {FootholdWay::rays, FootholdWay::surface}) {
        const Foothold found = find(cube, way, ground, {0.3, 1.05, 0.2}, leg, 0.1);
        REQUIRE(found.found);
        CHECK(distance(found.position, {0.3, 1, 0.2}) < 1e-12);
        CHECK(distance(found.up, {0, 1, 0}) < 1e-12);
    }
}

TEST_CASE("over an edge the ray along the surface finds the side, rays up and down must search", "[unit]") {
    const Land cube(mesh::cube(2, 4));
    const Footing ground = cube.stand({0.9, 1, 0}, {0, 1, 0}, {1, 0, 0});
    const LegReach leg{{0.9, 1.1, 0}, 0.01, 0.5};
    const Vec3 wanted{1.15, 1, 0};
    const Foothold along = find(cube, FootholdWay::surface, ground, wanted, leg, 0.2);
    REQUIRE(along.found);
    CHECK(distance(along.position, {1, 0.85, 0}) < 1e-12);
    CHECK(distance(along.up, {1, 0, 0}) < 1e-12);
    const Foothold by_rays = find(cube, FootholdWay::rays, ground, wanted, leg, 0.2);
    REQUIRE(by_rays.found);
    CHECK(by_rays.position.x <= 1);
    CHECK(distance(by_rays.position, wanted) <= 0.2 + 1e-12);
}

TEST_CASE("in an inside corner the foot goes up the wall, not through it", "[unit]") {
    const Land room(mesh::room(2, 4));
    const Footing ground = room.stand({0.9, -1, 0}, {0, 1, 0}, {1, 0, 0});
    const LegReach leg{{0.85, -0.9, 0}, 0.01, 0.5};
    const Foothold found = find(room, FootholdWay::surface, ground, {1.1, -1, 0}, leg, 0.1);
    REQUIRE(found.found);
    CHECK(distance(found.position, {1, -0.9, 0}) < 1e-12);
    CHECK(distance(found.up, {-1, 0, 0}) < 1e-12);
}

TEST_CASE("what is out of reach is searched for nearer by, and not found where there is nothing", "[unit]") {
    const Land cube(mesh::cube(2, 4));
    const Footing ground = cube.stand({0, 1, 0}, {0, 1, 0}, {1, 0, 0});
    const LegReach shorter{{0, 1.1, 0}, 0.01, 0.25};
    const Foothold nearer = find(cube, FootholdWay::surface, ground, {0.3, 1, 0}, shorter, 0.15);
    REQUIRE(nearer.found);
    CHECK(distance(nearer.position, shorter.hip) <= 0.25);
    CHECK(nearer.position.x > 0.1);
    const LegReach hopeless{{0, 3, 0}, 0.01, 0.25};
    for (const FootholdWay way : {FootholdWay::rays, FootholdWay::surface})
        CHECK_FALSE(find(cube, way, ground, {0.3, 3, 0}, hopeless, 0.15).found);
}

TEST_CASE("glass holds a foot where it is level enough for its friction, and nowhere else", "[unit]") {
    const SurfaceGrip glass{0.5, false}, rock{0.5, true};
    const auto leaning = [](double degrees) {
        const double angle = degrees * M_PI / 180;
        return Vec3{std::sin(angle), std::cos(angle), 0};
    };
    CHECK(holds(glass, leaning(26.5), kGravity));  // atan 0.5 = 26.57 degrees
    CHECK_FALSE(holds(glass, leaning(26.6), kGravity));
    CHECK_FALSE(holds(glass, leaning(180), kGravity));
    CHECK(holds(rock, leaning(180), kGravity));
    CHECK(holds(glass, leaning(180), {}));
}

TEST_CASE("where the surface ends before the foot its rim is a place to stand", "[unit]") {
    const Land strip(mesh::height_field(1, 1));
    const Footing ground = strip.stand({0.48, 1, 0}, {0, 1, 0}, {1, 0, 0});
    const LegReach leg{{0.45, 0.05, 0}, 0.01, 0.5};
    const Foothold found =
        find(strip, FootholdWay::surface, ground, ground.position + Vec3{0.1, 0, 0}, leg, 0.05);
    REQUIRE(found.found);
    CHECK(found.position.x == Approx(0.5).epsilon(1e-12));
    CHECK(found.rim);
}
