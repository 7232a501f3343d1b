#include "wide_tree.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "balls.hpp"
#include "closest_point.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::Ball;
using orbweaver::surface::test::rough_ball;

namespace {

WideTreeData changed(WideTreeData tree, void (*change)(WideTreeData&)) {
    change(tree);
    return tree;
}

}  // namespace

TEST_CASE("every triangle is in one leaf, whatever the mesh", "[unit]") {
    std::vector<Ball> meshes = {rough_ball(2, 1, {}), rough_ball(16, 1e-8, {3, 4, 5})};
    // A thousand triangles in one place, and a row each twice as large as the one before: nothing for a
    // heuristic.
    Ball heap = rough_ball(2, 1, {});
    heap.triangles.assign(1000, heap.triangles[0]);
    meshes.push_back(heap);
    Ball row;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const double s = std::ldexp(1, static_cast<int>(i) - 150);
        row.vertices.insert(row.vertices.end(), {{s, 0, 0}, {2 * s, 0, 0}, {s, s, 0}});
        row.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    meshes.push_back(row);
    meshes.push_back({});
    for (const Ball& mesh : meshes) {
        const WideTreeData tree = build_wide_tree(mesh.set());
        CHECK(fault_of(tree.view(), mesh.set()).empty());
    }
}

TEST_CASE("the same mesh gives the same tree, bit for bit", "[unit]") {
    const Ball ball = rough_ball(12, 1, {});
    const WideTreeData a = build_wide_tree(ball.set()), b = build_wide_tree(ball.set());
    REQUIRE(a.nodes.size() == b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        CHECK(a.nodes[i].planes == b.nodes[i].planes);
        CHECK(a.nodes[i].children == b.nodes[i].children);
    }
}

TEST_CASE("no plane of a box is denormal, where the mesh has its vertices in the middle too", "[unit]") {
    Ball cross;  // three squares about the origin, one across each axis
    cross.vertices = {{-1, -1, 0}, {1, -1, 0},  {1, 1, 0},  {0, -1, -1}, {0, 1, -1},
                      {0, 1, 1},   {-1, 0, -1}, {1, 0, -1}, {1, 0, 1},   {0, 0, 0}};
    for (std::uint32_t i = 0; i < 9; i += 3) {
        cross.triangles.push_back({i, i + 1, i + 2});
        cross.triangles.push_back({i, i + 1, 9});
        cross.triangles.push_back({i + 1, i + 2, 9});
    }
    const WideTreeData tree = build_wide_tree(cross.set());
    CHECK(fault_of(tree.view(), cross.set()).empty());
    int beside_the_middle = 0;
    for (const WideNode& node : tree.nodes)
        for (const auto& planes : node.planes)
            for (const float plane : planes) {
                CHECK(std::fpclassify(plane) != FP_SUBNORMAL);
                beside_the_middle += plane != 0 && std::abs(plane) < 1e-20F ? 1 : 0;
            }
    CHECK(beside_the_middle > 0);
}

TEST_CASE("a tree that does not fit its mesh is told in words", "[unit]") {
    const Ball ball = rough_ball(6, 1, {});
    const WideTreeData sound = build_wide_tree(ball.set());
    struct Case {
        void (*change)(WideTreeData&);
        std::string fault;
    };
    const std::vector<Case> cases = {
        {[](WideTreeData& t) { t.triangles.pop_back(); }, "the tree holds 119 triangles of 120"},
        {[](WideTreeData& t) { t.nodes.clear(); }, "the tree holds 120 triangles of 120"},
        {[](WideTreeData& t) { t.frame.size = 0; }, "the tree's frame is not finite"},
        {[](WideTreeData& t) { t.frame.middle.x = NAN; }, "the tree's frame is not finite"},
        {[](WideTreeData& t) { t.nodes[0].children[0] = 0; }, "node 0 of the tree has node 0 below it, of "},
        {[](WideTreeData& t) { t.nodes[0].children[0] = 9999; },
         "node 0 of the tree has node 9999 below it, of "},
        {[](WideTreeData& t) { t.nodes[0].planes[1][0] = -INFINITY; },
         "node 0 of the tree has a child without a box"},
        {[](WideTreeData& t) { t.nodes.back().children[0] = leaf(119, 4); },
         "a leaf of the tree ends at triangle 123 of 120"},
        {[](WideTreeData& t) { t.nodes.back().children[0] = leaf(0, 1); }, " of the tree is in "},
        {[](WideTreeData& t) { t.nodes.back().children[0] = leaf(0, 5); },
         "a leaf of the tree has 5 triangles; expected at most 4"},
        {[](WideTreeData& t) { t.triangles[0].face = t.triangles[1].face; },
         " in the tree is not the mesh's, or is there twice"},
        {[](WideTreeData& t) { t.triangles[0].corners[0] = 9999; },
         " in the tree is not the mesh's, or is there twice"}};
    for (const auto& [change, fault] : cases) {
        CAPTURE(fault);
        CHECK_THAT(fault_of(changed(sound, change).view(), ball.set()), Catch::Contains(fault));
    }
}

TEST_CASE("the nearest point is that of every triangle tried in turn", "[unit]") {
    for (const double scale : {1e-8, 1.0, 1e6})
        for (const double offset : {0.0, 1e6}) {
            CAPTURE(scale, offset);
            const Vec3 middle{offset * scale, 0, 0};
            const Ball ball = rough_ball(12, scale, middle);
            const WideTreeData tree = build_wide_tree(ball.set());
            const RandomStream random(2, "points");
            double worst = 0;
            for (std::uint64_t i = 0; i < 500; ++i) {
                const double far = std::ldexp(1, static_cast<int>(i % 20) - 2);  // from within to 2^17 radii
                const Vec3 q = middle + far * scale *
                                            Vec3{random.uniform(3 * i, -1, 1), random.uniform(3 * i + 1, -1, 1),
                                                 random.uniform(3 * i + 2, -1, 1)};
                double best = std::numeric_limits<double>::infinity();
                for (std::uint32_t face = 0; face < ball.triangles.size(); ++face)
                    best = std::min(
                        best, distance(q, position_of(ball.set(),
                                                      {face, closest_weights(ball.set().corners(face), q)})));
                const SurfaceHit hit =
                    closest_point(tree.view(), ball.set(), q, std::numeric_limits<double>::infinity());
                REQUIRE(hit.answer == Answer::found);
                worst = std::max(worst, std::abs(hit.distance - best));
                CHECK(closest_point(tree.view(), ball.set(), q, 0.9 * best).answer == Answer::nothing);
            }
            CHECK(worst == 0);
        }
}

TEST_CASE("the nearest point of a triangle is on the corner, edge or inside that it should be", "[unit]") {
    const std::array<Vec3, 3> p = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
    using Weights = std::array<double, 3>;
    CHECK(closest_weights(p, {-1, -1, 5}) == Weights{1, 0, 0});
    CHECK(closest_weights(p, {5, 0, 1}) == Weights{0, 1, 0});
    CHECK(closest_weights(p, {0, 5, 1}) == Weights{0, 0, 1});
    CHECK(closest_weights(p, {1, -3, 1}) == Weights{0.5, 0.5, 0});
    CHECK(closest_weights(p, {-3, 1, 1}) == Weights{0.5, 0, 0.5});
    CHECK(closest_weights(p, {3, 3, 1}) == Weights{0, 0.5, 0.5});
    CHECK(closest_weights(p, {0.5, 0.5, 7}) == Weights{0.5, 0.25, 0.25});
}

TEST_CASE("a point or a reach that means nothing is refused", "[unit]") {
    const Ball ball = rough_ball(4, 1, {});
    const WideTreeData tree = build_wide_tree(ball.set());
    CHECK(closest_point(tree.view(), ball.set(), {NAN, 0, 0}, 1).answer == Answer::refused);
    CHECK(closest_point(tree.view(), ball.set(), {0, 0, 0}, NAN).answer == Answer::refused);
    CHECK(closest_point(tree.view(), ball.set(), {0, 0, 0}, -1).answer == Answer::refused);
}
