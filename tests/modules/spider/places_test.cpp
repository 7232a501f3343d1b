#include "places.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "land.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using land::Land;

namespace {

constexpr Vec3 kGravity{0, -9.81, 0};

std::vector<Vec3> fill(Places& places, std::uint64_t count) {
    std::vector<Vec3> taken;
    for (std::uint64_t i = 0; i < count; ++i) {
        const Places::Found found = places.at_random(i, count, {});
        REQUIRE(found.holds);
        taken.push_back(found.place.end.position);
        places.take(taken.back());
    }
    return taken;
}

}  // namespace

TEST_CASE("a place near a point is on the point's side, and faces as asked or as it can", "[unit]") {
    const Land cube(mesh::cube(2, 4));
    const Places places(cube.surface(), kGravity, 0.1, RandomStream(1, "places"));
    const Places::Found above = places.near({0.3, 1.5, 0.2}, {1, 0, 0});
    CHECK(above.holds);
    CHECK(distance(above.place.end.position, {0.3, 1, 0.2}) < 1e-12);
    CHECK(above.place.end.up == Vec3{0, 1, 0});
    CHECK(places.near({0.3, 0.9, 0.2}, {1, 0, 0}).place.end.up == Vec3{0, -1, 0});
    const Places::Found beside = places.near({1.1, 0, 0}, {1, 0, 0});  // the side lies across its heading
    CHECK(beside.holds);
    CHECK(std::abs(beside.place.end.forward.x) < 1e-12);
}

TEST_CASE("a point finds the surface however far it is", "[unit]") {
    const Land far(mesh::transformed(mesh::cube(1, 2), 1, {1000, 0, 0}));
    const Places places(far.surface(), kGravity, 0.1, RandomStream(1, "places"));
    const Places::Found found = places.near({0, 0, 0}, {0, 0, 1});
    CHECK(found.holds);
    CHECK(distance(found.place.end.position, {999.5, 0, 0}) < 1e-9);
}

TEST_CASE("where there is room those placed at random are apart", "[unit]") {
    const Land cube(mesh::cube(1, 4));
    Places places(cube.surface(), kGravity, 0.1, RandomStream(1, "places"));
    const std::vector<Vec3> taken = fill(places, 100);  // of about 600 that would fit
    for (std::size_t i = 0; i < taken.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(distance(taken[i], taken[k]) >= 0.1);
}

TEST_CASE("where there is none they are placed all the same", "[unit]") {
    const Land cube(mesh::cube(0.1, 1));
    Places places(cube.surface(), kGravity, 0.1, RandomStream(1, "places"));
    CHECK(fill(places, 50).size() == 50);
}

TEST_CASE("nobody is placed where no foot holds, however little else there is", "[unit]") {
    surface::GripOverrides grips;
    grips.all = {0.1, false};
    const Land room(mesh::room(1, 2), grips);
    Places places(room.surface(), kGravity, 0.05, RandomStream(1, "places"));
    for (const Vec3& place : fill(places, 40)) CHECK(place.y == -0.5);
    CHECK_FALSE(places.near({0.5, 0, 0}, {0, 1, 0}).holds);
    grips.all = {0.1, false};
    const Land ball(mesh::sphere(1, 8), grips);
    const Places none(ball.surface(), {9.81, 0, 0}, 0.05, RandomStream(1, "places"));
    CHECK_FALSE(none.near({1, 0, 0}, {0, 1, 0}).holds);
}
