#include "sketch.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::crawler;

TEST_CASE("a sketch shows every spine, and forces in proportion to weights", "[unit]") {
    const Lattice lattice{2, 5};
    const Build build{5, 0.5, 0.1, 2.4, 0, 0};
    const Pose poses[] = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 3}, {0, 0, 1}, {0, 1, 0}}};
    const std::vector<Vec3> x = straight_points(lattice, build, poses);
    std::vector<Vec3> reaction(x.size());
    reaction[7] = {0, 10 * build.point_mass() * 9.81, 0};
    reaction[30] = {0, 0, -5 * build.point_mass() * 9.81};
    std::vector<SketchLine> lines(1);
    add_sketch(lattice, build, 9.81, x, reaction, lines);
    REQUIRE(lines.size() == 1 + 2 * 5 + 2);
    CHECK(distance(lines[1].a, {-0.25, 0, 0}) < 1e-15);
    CHECK(distance(lines[1].b, {-0.15, 0, 0}) < 1e-15);
    CHECK(distance(lines[10].b, {0, 0, 3.25}) < 1e-15);
    CHECK(distance(lines[11].a, x[7]) == 0);
    CHECK(distance(lines[11].b, x[7] + Vec3{0, 0.2, 0}) < 1e-15);
    CHECK(distance(lines[12].b, x[30] - Vec3{0, 0, 0.1}) < 1e-15);

    lines.clear();
    add_sketch(lattice, build, 0, x, reaction, lines);
    CHECK(lines.size() == 10);  // without weight there is nothing to measure forces by
}

TEST_CASE("a sketch of a cliff lies on it, all along its profile", "[unit]") {
    const Cliff cliff{0.3, 0.1, 0.02, 0.06};
    std::vector<SketchLine> lines;
    add_cliff(cliff, 0.5, lines);
    bool is_above = false, is_below = false, is_round = false;
    for (const SketchLine& line : lines)
        for (const Vec3& p : {line.a, line.b}) {
            CHECK(std::abs(cliff.touch(p, 0).depth) < 1e-12);
            CHECK(std::abs(p.z) <= 0.5);
            is_above |= p.x < -0.3;
            is_below |= p.x > 0.5;
            is_round |= p.x > 0.08 && p.x < 0.1 && p.y < 0.3;
        }
    CHECK((is_above && is_below && is_round));
}
