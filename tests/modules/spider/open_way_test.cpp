#include "open_way.hpp"

#include <catch2/catch.hpp>

#include "walker.hpp"

using namespace walker;
using land::Land;

namespace {

constexpr Vec3 kGravity{0, -9.81, 0};

/// A room whose wall at +x no foot holds on.
Land glass_room() {
    surface::GripOverrides grips;
    grips.patches.push_back({0.1, false});
    grips.patched.push_back({32, 47, 0});
    return Land(mesh::room(0.5, 4), grips);
}

}  // namespace

TEST_CASE("the way on turns aside before a border, by as little as it takes", "[unit]") {
    const Land field(mesh::t_junction(2, 2));
    const Footing ground = field.stand({0.95, 0, 0}, {0, 1, 0}, {1, 0, 0});
    const Vec3 inward = open_way(field.surface(), ground, {-0.1, 0, 0}, 1, kGravity);
    CHECK(inward == Vec3{-0.1, 0, 0});
    const Vec3 aside = open_way(field.surface(), ground, {0.1, 0, 0}, 1, kGravity);
    CHECK(norm(aside) == Approx(0.1));
    CHECK(aside.x == Approx(0.05));  // 60 degrees: 5 cm of the 10 are left
    CHECK(open_way(field.surface(), ground, {}, 1, kGravity) == Vec3{});
}

TEST_CASE("nobody heads up glass, and everybody does up a wall", "[unit]") {
    const Land room = glass_room();
    for (const double side : {-1.0, 1.0}) {
        const Footing ground = room.stand({side * 0.22, -0.25, 0}, {0, 1, 0}, {side, 0, 0});
        const Vec3 wanted{side * 0.1, 0, 0};
        const Vec3 way = open_way(room.surface(), ground, wanted, 0.5, kGravity);
        CHECK((way == wanted) == (side < 0));
        CHECK(is_open(room.surface(), ground, way / norm(way), 0.05, kGravity));
    }
}

TEST_CASE("glass is never stood upon, by body or foot, however long it is headed for", "[unit]") {
    const Land room = glass_room();
    Conduct conduct = purposeful();
    conduct.behaviors.seek = {WayField(room.surface(), spot(room, {0.25, 0, 0})), 1};
    conduct.behaviors.wander = 1;
    Walker walker(room, conduct, {0, -0.25, 0}, {0, 1, 0}, {1, 0, 0});
    double farthest = 0;
    for (int i = 0; i < 60 * 60; ++i) {
        walker.step();
        farthest = std::max(farthest, walker.position().x);
        REQUIRE(room.surface().grip(walker.state.ground.footing.at.face).climbable);
        for (std::size_t leg = 0; leg < 8; ++leg) {
            const Foot& foot = walker.state.feet[leg];
            if (walker.state.progress[leg] < 0 && foot.holds)
                REQUIRE(room.surface().grip(spot(room, foot.place).face).climbable);
        }
    }
    CHECK(farthest > 0.2);  // it did come to the pane
    CHECK(walker.measures.turned_aside > 100);
}
