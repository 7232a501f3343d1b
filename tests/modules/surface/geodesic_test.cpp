#include "geodesic.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "obj_mesh.hpp"
#include "shapes.hpp"
#include "wide_tree.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::built;

namespace {

/// Somebody on the face nearest to `position`.
Footing standing(const mesh::SurfaceMesh& mesh, const Vec3& position, const Vec3& up, const Vec3& forward) {
    const WideTreeData tree = build_wide_tree(triangles_of(mesh));
    const SurfaceHit hit = closest_point(tree.view(), triangles_of(mesh), position, 1);
    REQUIRE(hit.answer == Answer::found);
    const SurfaceStep placed = place(mesh, hit.at, up, forward);
    REQUIRE(placed.answer == Answer::found);
    return placed.end;
}

}  // namespace

TEST_CASE("a line over a cube's edges comes back to where it began after four sides", "[unit]") {
    for (const std::uint32_t subdivision : {1, 3, 8}) {
        const auto cube = built(mesh::cube(2, subdivision));
        const auto mesh = cube.view();
        const Footing begin = standing(mesh, {0.21, 0.13, 1}, {0, 0, 1}, {1, 0, 0});
        CHECK(begin.up == Vec3{0, 0, 1});
        const SurfaceStep end = step(mesh, begin, 8);
        REQUIRE(end.answer == Answer::found);
        CHECK(end.stop == StepStop::none);
        CHECK(end.walked == 8);
        CHECK(distance(end.end.position, begin.position) < 1e-14);
        CHECK(distance(end.end.forward, begin.forward) < 1e-14);
        const SurfaceStep side = step(mesh, begin, 2);  // 0.79 to the edge, 1.21 beyond it
        CHECK(distance(side.end.position, {1, 0.13, -0.21}) < 1e-14);
        CHECK(distance(side.end.up, {1, 0, 0}) < 1e-14);
        CHECK(distance(side.end.forward, {0, 0, -1}) < 1e-14);
    }
}

TEST_CASE("on the inside of the same cube, and in a room, the line climbs the wall", "[unit]") {
    for (const bool room : {false, true}) {
        const auto box = built(room ? mesh::room(2, 4) : mesh::cube(2, 4));
        const auto mesh = box.view();
        const Footing begin = standing(mesh, {0.21, -1, 0.13}, {0, 1, 0}, {1, 0, 0});
        CHECK(begin.side == (room ? 1 : -1));
        const SurfaceStep wall = step(mesh, begin, 1);
        CHECK(distance(wall.end.position, {1, -0.79, 0.13}) < 1e-14);
        CHECK(distance(wall.end.up, {-1, 0, 0}) < 1e-14);
        const SurfaceStep ceiling = step(mesh, begin, 3.5);
        CHECK(distance(ceiling.end.position, {0.29, 1, 0.13}) < 1e-14);
        CHECK(distance(ceiling.end.up, {0, -1, 0}) < 1e-14);
        CHECK(distance(ceiling.end.forward, {-1, 0, 0}) < 1e-14);
    }
}

TEST_CASE("at a vertex the angle is halved: down a cube's edge from its corner (Polthier and Schmies 1998)",
          "[unit]") {
    // Three right angles meet: 3 pi / 2 in all. The diagonal has pi / 4 of the top on either side, and then a
    // whole side's pi / 2 to the edge opposite to it, which is half.
    for (const std::uint32_t subdivision : {1, 2, 5}) {
        const auto cube = built(mesh::cube(2, subdivision));
        const auto mesh = cube.view();
        for (const int to_x : {-1, 1})
            for (const int to_z : {-1, 1}) {
                const double x = to_x, z = to_z;
                const Footing begin = standing(mesh, {0.75 * x, 1, 0.75 * z}, {0, 1, 0}, {x, 0, z});
                const SurfaceStep end = step(mesh, begin, 0.25 * std::sqrt(2.0) + 0.3);
                REQUIRE(end.stop == StepStop::none);
                CHECK(distance(end.end.position, {x, 0.7, z}) < 1e-14);
                CHECK(distance(end.end.forward, {0, -1, 0}) < 1e-14);
            }
    }
}

TEST_CASE("in a flat floor vertices are crossed straight on", "[unit]") {
    mesh::RawMesh raw = mesh::t_junction(2, 4);
    const auto floor = built(raw);
    const auto mesh = floor.view();
    const Footing begin = standing(mesh, {0.125, 0, -0.875}, {0, 1, 0}, {1, 0, 1});  // along the diagonals
    const SurfaceStep end = step(mesh, begin, 0.7 * std::sqrt(2.0));
    CHECK(end.stop == StepStop::none);
    CHECK(distance(end.end.position, {0.825, 0, -0.175}) < 1e-14);
    CHECK(distance(end.end.forward, {std::sqrt(0.5), 0, std::sqrt(0.5)}) < 1e-14);
}

TEST_CASE("a border ends the walk where it is met", "[unit]") {
    const auto hills = built(mesh::height_field(1, 8));
    const auto mesh = hills.view();
    const Footing begin = standing(mesh, {0.1, 0, 0.1}, {0, 1, 0}, {1, 0, 0});
    const SurfaceStep end = step(mesh, begin, 3);
    CHECK(end.answer == Answer::found);
    CHECK(end.stop == StepStop::border);
    CHECK(end.walked < 1);
    CHECK(end.end.position.x == Approx(0.5).margin(1e-15));
    // And there it stays.
    const SurfaceStep again = step(mesh, end.end, 1);
    CHECK(again.stop == StepStop::border);
    CHECK(again.walked == 0);
}

TEST_CASE("once round a Moebius strip one stands on the other side of the same place", "[unit]") {
    const auto strip = built(mesh::moebius_strip(2, 8));
    const auto mesh = strip.view();
    Footing at = standing(mesh, {0.75, 0, 0}, {0, 1, 0}, {0, 0, -1});
    const Footing begin = at;
    // Straight ahead would leave the strip: steer along its middle.
    double turned = 0;
    while (turned < 3) {
        const SurfaceStep end = step(mesh, at, 0.01);
        REQUIRE(end.stop == StepStop::none);
        const Vec3 p = end.end.position;
        const SurfaceStep next =
            place(mesh, end.end.at, end.end.up, Vec3{p.z, 0, -p.x} + 3.0 * (0.75 - norm(p)) * p);
        REQUIRE(next.answer == Answer::found);
        if (distance(p, begin.position) < 0.02 && turned > 0.5) break;
        CHECK(next.end.side == end.end.side);
        turned += 0.01 / (2 * 3.14159265358979 * 0.75);
        at = next.end;
    }
    CHECK(turned == Approx(1).margin(0.02));
    CHECK(dot(at.up, begin.up) < -0.9);
}

TEST_CASE("where three faces meet in an edge one stays on one's own side", "[unit]") {
    const auto blades = built(mesh::fan(2, 4));  // at 0, 120 and 240 degrees about y
    const auto mesh = blades.view();
    // On the first blade, on the side towards the second (-z), walking to the axis: out along the second blade.
    const Footing begin = standing(mesh, {0.5, 0.1, 0}, {0, 0, -1}, {-1, 0, 0});
    const SurfaceStep end = step(mesh, begin, 1);
    CHECK(end.stop == StepStop::none);
    const Vec3 second{-0.5, 0, -std::sqrt(0.75)};
    CHECK(distance(end.end.position, 0.5 * second + Vec3{0, 0.1, 0}) < 1e-14);
    CHECK(distance(end.end.forward, second) < 1e-14);
    CHECK(dot(end.end.up, {1, 0, 0}) > 0.8);  // facing the first
    // On its other side: out along the third.
    const SurfaceStep other = step(mesh, standing(mesh, {0.5, 0.1, 0}, {0, 0, 1}, {-1, 0, 0}), 1);
    CHECK(distance(other.end.position, {-0.25, 0.1, 0.5 * std::sqrt(0.75)}) < 1e-14);
    CHECK(dot(other.end.up, {1, 0, 0}) > 0.8);
}

TEST_CASE("a footing that means nothing is refused", "[unit]") {
    const auto cube = built(mesh::cube(2, 2));
    const auto mesh = cube.view();
    const Footing sound = standing(mesh, {0.2, 0.1, 1}, {0, 0, 1}, {1, 0, 0});
    const double nan = std::nan("");
    Footing wrong = sound;
    wrong.at.face = 48;
    CHECK(step(mesh, wrong, 1).answer == Answer::refused);
    wrong = sound;
    wrong.at.weights[1] = nan;
    CHECK(step(mesh, wrong, 1).answer == Answer::refused);
    wrong = sound;
    wrong.at.weights[1] += 0.5;
    CHECK(step(mesh, wrong, 1).answer == Answer::refused);
    wrong = sound;
    wrong.forward = {0, 0, 1};
    CHECK(step(mesh, wrong, 1).answer == Answer::refused);
    wrong = sound;
    wrong.side = 0;
    CHECK(step(mesh, wrong, 1).answer == Answer::refused);
    for (const double length : {nan, -1.0, static_cast<double>(INFINITY)})
        CHECK(step(mesh, sound, length).answer == Answer::refused);
    CHECK(place(mesh, sound.at, {0, 0, 1}, {0, 0, 2}).answer == Answer::refused);
    CHECK(place(mesh, sound.at, {nan, 0, 1}, {1, 0, 0}).answer == Answer::refused);
}

TEST_CASE("a step of absurd length ends and says so", "[extreme]") {
    const auto cube = built(mesh::cube(2, 8));
    const Footing begin = standing(cube.view(), {0.2, 0.1, 1}, {0, 0, 1}, {1, 0.3, 0});
    const SurfaceStep end = step(cube.view(), begin, 1e12);
    CHECK(end.stop == StepStop::limit);
    CHECK(end.crossings == kMostCrossings);
}
