#include "way_field.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "land.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using land::Land;

namespace {

SurfacePoint at(const Land& land, const Vec3& point) { return land.surface().closest_point(point, 10).at; }

double way_length(const WayField& field, const Land& land, const Vec3& from) {
    return distance(field.seen_from(at(land, from)), from);
}

}  // namespace

TEST_CASE("on flat land the target is seen where it is", "[unit]") {
    for (const std::uint32_t n : {1U, 3U, 8U}) {
        const Land cube(mesh::cube(2, n));
        const WayField field(cube.surface(), at(cube, {0.31, 1, -0.42}));
        for (const Vec3 from :
             {Vec3{-0.9, 1, 0.9}, Vec3{0.8, 1, 0.77}, Vec3{-0.1, 1, -0.93}, Vec3{0.3, 1, -0.4}})
            CHECK(distance(field.seen_from(at(cube, from)), {0.31, 1, -0.42}) < 1e-12);
    }
}

TEST_CASE("over a cube's edge the way is the straight line of the unfolded sides", "[unit]") {
    for (const std::uint32_t n : {1U, 8U}) {
        const Land cube(mesh::cube(2, n));
        const WayField field(cube.surface(), at(cube, {1, 0.5, 0.6}));
        // Unfolded, the target lies 0.5 m beyond the edge x = 1.
        const Vec3 seen = field.seen_from(at(cube, {0.3, 1, -0.2}));
        CHECK(distance(seen, {1.5, 1, 0.6}) < 1e-12);
    }
}

TEST_CASE("a target on an edge of the mesh is seen where it is, from all around", "[unit]") {
    for (const std::uint32_t n : {1U, 2U, 5U}) {
        INFO(n);
        const Land cube(mesh::cube(0.4, n));
        for (const Vec3 goal :
             {Vec3{0.2, 0.2, 0}, Vec3{0.05, 0.2, 0.05}, Vec3{0, 0.2, 0}, Vec3{0.2, 0.2, 0.2}}) {
            const WayField field(cube.surface(), at(cube, goal));
            const auto check = [&](const Vec3& from) {
                const Vec3 way = field.seen_from(at(cube, from)) - from;
                CHECK(norm(way) == Approx(distance(goal, from)).margin(1e-9));
            };
            for (const double off : {0.1, 1e-3, 1e-6, 1e-9})
                for (const double aside : {-1.0, 0.0, 0.3, 1.0}) {
                    INFO(off << " " << aside);
                    check(goal + Vec3{-off, 0, -aside * off});
                    if (goal.x == 0.2) check(goal + Vec3{0, -off, -aside * off * (goal.z == 0 ? 1 : 0)});
                }
        }
    }
}

TEST_CASE("ways round a sphere are great circles, the better the finer it is", "[unit]") {
    double last = 1;
    for (const std::uint32_t n : {8U, 32U}) {
        const Land sphere(mesh::sphere(2, n));
        const WayField field(sphere.surface(), at(sphere, {0.6, 0.8, 0}));
        double worst = 0;
        for (const Vec3 from : {Vec3{-0.8, 0.6, 0}, Vec3{0, -0.6, 0.8}, Vec3{0.36, 0.48, -0.8}}) {
            const Vec3 place = sphere.surface().position(at(sphere, from));
            const double exact = std::acos(dot(from, {0.6, 0.8, 0}));
            worst = std::max(worst, std::abs(way_length(field, sphere, place) - exact));
        }
        CHECK(worst < last / 2);
        last = worst;
    }
    CHECK(last < 0.02);
}

TEST_CASE("the shortest way goes over the rim of a cliff, all of it on the surface", "[unit]") {
    const Land cliff(mesh::cliff(2, 8));
    // Ground, wall and plateau unfold into one plane, in which both ends have the same z: 0.4, |wall| and 0.9
    // m.
    const double wall = std::sqrt(1.25);
    const auto way = shortest_way(cliff.surface(), at(cliff, {-0.4, 0, 0.1}), at(cliff, {0.4, 1, 0.1}), 0.01);
    double length = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        length += distance(way[i], way[i + 1]);
        CHECK(distance(way[i], way[i + 1]) <= 0.01 * (1 + 1e-9));
        CHECK(cliff.surface().closest_point(way[i], 1).distance < 1e-12);
        CHECK(std::abs(way[i].z - 0.1) < 1e-9);
    }
    CHECK(length < 0.4 + wall + 0.9 + 1e-9);
    CHECK(length > 0.4 + wall + 0.9 - 0.02);  // two corners are cut by one step at most
    CHECK(distance(way.back(), {0.4, 1, 0.1}) < 1e-12);
}

TEST_CASE("where no way leads the target is seen straight through the air", "[unit]") {
    mesh::RawMesh two = mesh::cube(1, 1);
    const mesh::RawMesh other = mesh::transformed(mesh::cube(1, 1), 1, {3, 0, 0});
    const auto base = static_cast<std::uint32_t>(two.points.size());
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (std::uint32_t i = 0; i + 3 < other.points.size(); i += 4)
        two.add_polygon({base + i, base + i + 1, base + i + 3, base + i + 2});
    const Land land(two);
    const WayField field(land.surface(), at(land, {0, 0.5, 0}));
    CHECK_FALSE(field.leads_from(at(land, {3, 0.5, 0})));
    CHECK(field.leads_from(at(land, {0, -0.5, 0})));
    CHECK(distance(field.seen_from(at(land, {3, 0.5, 0})), {0, 0.5, 0}) < 1e-12);
    const auto way = shortest_way(land.surface(), at(land, {3, 0.5, 0}), at(land, {0, 0.5, 0}), 0.1);
    CHECK(way == std::vector<Vec3>{{3, 0.5, 0}, {0, 0.5, 0}});
}
