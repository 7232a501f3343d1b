#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "balls.hpp"
#include "every_triangle.hpp"
#include "fcl_tree.hpp"
#include "obj_mesh.hpp"
#include "ready_parts.hpp"
#include "sanitized.hpp"
#include "shapes.hpp"
#include "watertight.hpp"
#include "wide_tree.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::Ball;
using orbweaver::surface::test::rough_ball;

namespace {

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
    double worst_target = 0;   // from the vertex or the edge that was aimed at, relative
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
        if (wide.answer != Answer::found) ++tally.missed;
        if (slow.answer != Answer::found) ++tally.fcl_missed;
        const double aimed = distance(target, origin);  // the ball is seen from within: nothing lies before
        for (const SurfaceHit& hit : {wide, slow})
            tally.worst_target = std::max(tally.worst_target, relative(hit.distance, aimed));
        if (i % 10 != 0) continue;
        const SurfaceHit truth = first_hit_of_all(set, ray);
        tally.worst = std::max(tally.worst, relative(wide.distance, truth.distance));
        tally.worst_fcl = std::max(tally.worst_fcl, relative(slow.distance, truth.distance));
        const auto formula = static_cast<double>(plane_distance(set, wide.at.face, ray));
        tally.worst_formula = std::max(tally.worst_formula, relative(wide.distance, formula));
    }
    return tally;
}

/// From outside or inside, at anything or nothing.
SurfaceRay any_ray(const RandomStream& random, std::uint64_t& n, const Placement& place) {
    const auto in_box = [&](double half) {
        const Vec3 p{random.uniform(n, -half, half), random.uniform(n + 1, -half, half),
                     random.uniform(n + 2, -half, half)};
        n += 3;
        return p;
    };
    return {place.middle + 2 * place.radius * in_box(1), in_box(1), 4 * place.radius * random.uniform(n++)};
}

}  // namespace

TEST_CASE("no ray at a vertex or an edge is missed, at any scale and offset", "[extreme]") {
    // At each of ten placements a hundred thousand rays at vertices and as many at edges, from within, where
    // what they are aimed at is what they must find; one in ten is also held against every triangle.
    for (const Placement& place : placements()) {
        const Ball ball = rough_ball(8, place.radius, place.middle);
        for (const bool at_edges : {false, true}) {
            CAPTURE(place.radius, place.middle.x, at_edges);
            const Tally tally = shoot(ball, place, at_edges, repetitions(100'000));
            CHECK(tally.missed == 0);
            CHECK(tally.fcl_missed == 0);
            CHECK(tally.worst <= 1e-12);
            CHECK(tally.worst_fcl <= 1e-12);
            CHECK(tally.worst_formula <= 1e-12);
            // Far out a place on an edge is rounded off it, by half a unit in the last place of its
            // coordinates.
            const double grain = 0x1p-52 * norm(place.middle) / place.radius;
            CHECK(tally.worst_target <= 1e-12 + (at_edges ? 4 * grain : 0));
        }
    }
}

TEST_CASE("a hundred thousand rays at vertices and as many at edges of real meshes, none missed", "[extreme]") {
    for (const char* name : {"spot", "fandisk"}) {
        const auto data = test::built(test::read_obj(std::string(ORBWEAVER_MESHES "/") + name + ".obj"));
        const TriangleSet set{data.vertices, data.triangles};
        const WideTreeData tree = build_wide_tree(set);
        const FclTree fcl(set);
        const RandomStream random(9, name);
        const Vec3 middle = 0.5 * (data.bounds.min + data.bounds.max);
        const double size = norm(data.bounds.max - data.bounds.min);
        int missed = 0, fcl_missed = 0, differ = 0;
        double worst = 0;
        std::uint64_t n = 0;
        for (int i = 0; i < repetitions(200'000); ++i) {
            const Corners& c = set.triangles[random.bits(n++) % set.triangles.size()];
            const double t = i % 2 == 0 ? 0 : random.uniform(n++);
            const Vec3 target = set.vertices[c[0]] + t * (set.vertices[c[1]] - set.vertices[c[0]]);
            const Vec3 aside{random.uniform(n, -1, 1), random.uniform(n + 1, -1, 1),
                             random.uniform(n + 2, -1, 1)};
            n += 3;
            // From outside: one target in a hundred lies on the rim of what is seen.
            const Vec3 origin = middle + size * unit(aside);
            const SurfaceRay ray{origin, target - origin};
            const SurfaceHit wide = first_hit(tree.view(), set, ray);
            const SurfaceHit slow = fcl.first_hit(ray);
            missed += wide.answer != Answer::found;
            fcl_missed += slow.answer != Answer::found;
            worst = std::max(worst, relative(wide.distance, slow.distance));
            if (i % 50 >= 2) continue;  // one vertex and one edge in twenty-five: every triangle is dear
            const SurfaceHit truth = first_hit_of_all(set, ray);
            for (const SurfaceHit& hit : {wide, slow})
                differ += hit.answer != truth.answer || hit.at.face != truth.at.face ||
                          hit.distance != truth.distance;
        }
        CAPTURE(name);
        CHECK(differ == 0);
        CHECK(missed == 0);
        CHECK(fcl_missed == 0);
        CHECK(worst <= 1e-12);
    }
}

TEST_CASE("both trees say what every triangle tried in turn says, of rays that hit and that miss", "[unit]") {
    for (const Placement& place : placements()) {
        CAPTURE(place.radius, place.middle.x);
        const Ball ball = rough_ball(9, place.radius, place.middle);
        const TriangleSet set = ball.set();
        const WideTreeData tree = build_wide_tree(set);
        const FclTree fcl(set);
        const RandomStream random(4, "rays");
        std::uint64_t n = 0;
        int hits = 0, differ = 0;
        constexpr int kRays = 1000;
        for (int i = 0; i < kRays; ++i) {
            const SurfaceRay ray = any_ray(random, n, place);
            const SurfaceHit truth = first_hit_of_all(set, ray);
            hits += truth.answer == Answer::found;
            for (const SurfaceHit& hit : {first_hit(tree.view(), set, ray), fcl.first_hit(ray)})
                differ += hit.answer != truth.answer || hit.at.face != truth.at.face ||
                          hit.distance != truth.distance || hit.at.weights != truth.at.weights;
        }
        CHECK(differ == 0);
        CHECK(hits > kRays / 10);
        CHECK(hits < kRays * 9 / 10);
    }
}

TEST_CASE("a tree from a file answers as the one that was made, once its corners are", "[unit]") {
    const auto data = test::built(test::read_obj(ORBWEAVER_MESHES "/fandisk.obj"));
    const mesh::SurfaceMesh mesh = data.view();
    const TriangleSet set = triangles_of(mesh);
    const WideTreeData made = build_wide_tree(set);
    const ReadyParts parts(mesh, WideTree{made.frame, made.nodes, made.triangles});
    CHECK(parts.tree_bytes() == 0);
    const Vec3 middle = 0.5 * (mesh.bounds.min + mesh.bounds.max);
    const Placement place{norm(mesh.bounds.max - middle), middle};
    const RandomStream random(5, "rays");
    std::uint64_t n = 0;
    int hits = 0, differ = 0;
    for (int i = 0; i < 1000; ++i) {
        const SurfaceRay ray = any_ray(random, n, place);
        const SurfaceHit truth = first_hit(made.view(), set, ray), hit = first_hit(*parts.tree(), set, ray);
        hits += truth.answer == Answer::found;
        differ += hit.answer != truth.answer || hit.at.face != truth.at.face || hit.distance != truth.distance;
    }
    CHECK(hits > 10);
    CHECK(differ == 0);
    CHECK(parts.tree_bytes() >= 9 * sizeof(double) * set.triangles.size());
}

TEST_CASE("a hit tells distance, place and weights, on either face", "[unit]") {
    const std::vector<Vec3> vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const std::vector<Corners> triangles = {{0, 1, 2}};
    const TriangleSet set{vertices, triangles};
    const WideTreeData tree = build_wide_tree(set);
    for (const double from : {-2.0, 2.0}) {
        const SurfaceHit hit = first_hit(tree.view(), set, {{1, 2, from}, {0, 0, -from}});
        REQUIRE(hit.answer == Answer::found);
        CHECK(hit.distance == 1);  // in lengths of its direction
        CHECK(position_of(set, hit.at) == Vec3{1, 2, 0});
        CHECK(hit.at.weights == std::array<double, 3>{0.25, 0.25, 0.5});
    }
    CHECK(first_hit(tree.view(), set, {{1, 2, 2}, {0, 0, -1}, 2}).answer == Answer::found);
    CHECK(first_hit(tree.view(), set, {{1, 2, 2}, {0, 0, -1}, 1.999}).answer == Answer::nothing);
    CHECK(first_hit(tree.view(), set, {{1, 2, 2}, {0, 0, 1}}).answer == Answer::nothing);
    CHECK(first_hit(tree.view(), set, {{1, 2, 0}, {0, 0, 1}}).answer == Answer::found);  // begun on it
}

TEST_CASE("a ray that means nothing is refused by either tree", "[unit]") {
    const Ball ball = rough_ball(4, 1, {});
    const WideTreeData tree = build_wide_tree(ball.set());
    const FclTree fcl(ball.set());
    const double nan = std::nan(""), inf = INFINITY;
    std::vector<SurfaceRay> rays = {{{}, {}, 1}, {{}, {1, 0, 0}, nan}, {{}, {1, 0, 0}, -1}};
    for (const double bad : {nan, inf, -inf}) {
        for (const Vec3& v : {Vec3{bad, 0, 0}, Vec3{0, bad, 0}, Vec3{0, 0, bad}}) {
            rays.push_back({v, {1, 0, 0}});
            rays.push_back({{}, v});
        }
    }
    for (const SurfaceRay& ray : rays) {
        CHECK(first_hit(tree.view(), ball.set(), ray).answer == Answer::refused);
        CHECK(fcl.first_hit(ray).answer == Answer::refused);
        CHECK(first_hit(tree.view(), ball.set(), ray).at.face == kNoFace);
    }
}

TEST_CASE("directions along axes, and as short and long as numbers go, are answered", "[unit]") {
    const Ball ball = rough_ball(6, 1, {});
    const TriangleSet set = ball.set();
    const WideTreeData tree = build_wide_tree(set);
    const FclTree fcl(set);
    for (const double length : {1e-150, 1e-30, 1.0, 1e30, 1e150})
        for (const Vec3& axis :
             {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{-1, 1e-200, 0}, Vec3{1, 1, 0}}) {
            CAPTURE(length, axis.x, axis.y);
            const SurfaceRay ray{{0.01, 0.02, 0.03}, length * axis};
            const SurfaceHit truth = first_hit_of_all(set, ray);
            REQUIRE(truth.answer == Answer::found);
            CHECK(first_hit(tree.view(), set, ray).distance == truth.distance);
            CHECK(fcl.first_hit(ray).distance == truth.distance);
        }
}

TEST_CASE("a ray from so far away that single precision overflows ends, and tells the truth", "[unit]") {
    const Ball ball = rough_ball(6, 1, {});
    const TriangleSet set = ball.set();
    const WideTreeData tree = build_wide_tree(set);
    for (const double away : {1e12, 1e30, 1e60, 1e90}) {
        CAPTURE(away);
        const SurfaceRay ray{{0.01, away, 0.03}, {0, -1, 0}};
        const SurfaceHit hit = first_hit(tree.view(), set, ray), truth = first_hit_of_all(set, ray);
        CHECK(hit.answer == truth.answer);
        CHECK(hit.at.face == truth.at.face);
    }
}
