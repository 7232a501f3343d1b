#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "balls.hpp"
#include "fcl_tree.hpp"
#include "watertight.hpp"
#include "wide_tree.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::Ball;
using orbweaver::surface::test::rough_ball;

namespace {

/// Every triangle asked, none left out.
SurfaceHit brute_force(const TriangleSet& set, const SurfaceRay& ray) {
    NearestCrossing nearest(ray.reach);
    const WatertightRay tight(ray);
    for (std::uint32_t face = 0; face < set.triangles.size(); ++face)
        nearest.try_face(tight, set.vertices, set.triangles[face], face);
    return nearest.hit(set);
}

/// The distance to the plane of a face by cross products in extended precision: another formula, other
/// rounding.
long double plane_distance(const TriangleSet& set, std::uint32_t face, const SurfaceRay& ray) {
    using Wide = std::array<long double, 3>;
    const auto wide = [](const Vec3& v) { return Wide{v.x, v.y, v.z}; };
    const auto minus = [](const Wide& a, const Wide& b) { return Wide{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
    const auto dot = [](const Wide& a, const Wide& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto p = set.corners(face);
    const Wide a = minus(wide(p[1]), wide(p[0])), b = minus(wide(p[2]), wide(p[0]));
    const Wide n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return dot(n, minus(wide(p[0]), wide(ray.origin))) / dot(n, wide(ray.direction));
}

struct Placement {
    double radius;
    Vec3 middle;
};

std::vector<Placement> placements() {
    std::vector<Placement> all;
    for (const double radius : {1e-8, 1e-4, 1.0, 1e3, 1e6}) {
        all.push_back({radius, {}});
        all.push_back({radius, {1e6 * radius, -0.7e6 * radius, 0.3e6 * radius}});
    }
    return all;
}

/// Counts, so that a hundred thousand rays make one assertion.
struct Tally {
    int missed = 0;
    int fcl_missed = 0;
    double worst = 0;  // |distance - brute force|, relative
    double worst_fcl = 0;
    double worst_formula = 0;  // of the face that was hit, by the other formula
};

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

Tally shoot(const Ball& ball, const Placement& place, bool at_edges, int rays) {
    const TriangleSet set = ball.set();
    const WideTreeData tree = build_wide_tree(set);
    const FclTree fcl(set);
    const RandomStream random(7, at_edges ? "edges" : "vertices");
    Tally tally;
    std::uint64_t n = 0;
    for (int i = 0; i < rays; ++i) {
        const Corners& c = set.triangles[random.bits(n++) % set.triangles.size()];
        const double t = at_edges ? random.uniform(n++) : 0;
        const Vec3 target = set.vertices[c[0]] + t * (set.vertices[c[1]] - set.vertices[c[0]]);
        // From inside, where whatever the ray is aimed at is certainly in its way.
        const Vec3 inner{random.uniform(n, -0.3, 0.3), random.uniform(n + 1, -0.3, 0.3),
                         random.uniform(n + 2, -0.3, 0.3)};
        n += 3;
        const Vec3 origin = place.middle + place.radius * inner;
        const SurfaceRay ray{origin, unit(target - origin)};
        const SurfaceHit wide = first_hit(tree.view(), set, ray);
        const SurfaceHit slow = fcl.first_hit(ray);
        const SurfaceHit truth = brute_force(set, ray);
        REQUIRE(truth.answer == Answer::found);
        if (wide.answer != Answer::found) ++tally.missed;
        if (slow.answer != Answer::found) ++tally.fcl_missed;
        tally.worst = std::max(tally.worst, relative(wide.distance, truth.distance));
        tally.worst_fcl = std::max(tally.worst_fcl, relative(slow.distance, truth.distance));
        const auto formula = static_cast<double>(plane_distance(set, wide.at.face, ray));
        tally.worst_formula = std::max(tally.worst_formula, relative(wide.distance, formula));
    }
    return tally;
}

}  // namespace

TEST_CASE("no ray at a vertex or an edge is missed, at any scale and offset", "[extreme]") {
    for (const Placement& place : placements()) {
        const Ball ball = rough_ball(10, place.radius, place.middle);
        for (const bool at_edges : {false, true}) {
            CAPTURE(place.radius, place.middle.x, at_edges);
            const Tally tally = shoot(ball, place, at_edges, 2000);
            CHECK(tally.missed == 0);
            CHECK(tally.fcl_missed == 0);
            CHECK(tally.worst <= 1e-12);
            CHECK(tally.worst_fcl <= 1e-12);
            CHECK(tally.worst_formula <= 1e-12);
        }
    }
}
