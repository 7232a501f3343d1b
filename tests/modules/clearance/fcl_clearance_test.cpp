#include "fcl_clearance.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "balls.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::rough_ball;

namespace {

ProbeBody sphere(const Vec3& center, double radius) {
    ProbeBody body;
    body.center = center;
    body.size.x = radius;
    return body;
}

constexpr double kAnyFar = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a sphere is as far from the surface as its center, less its radius, at every scale", "[unit]") {
    for (const double scale : {1e-8, 1.0, 1e6}) {
        CAPTURE(scale);
        const auto ball = rough_ball(12, scale, {3 * scale, 0, 0});
        const FclClearance fcl(ball.set());
        const WideTreeData tree = build_wide_tree(ball.set());
        const RandomStream random(11, "bodies");
        double worst = 0, worst_point = 0;
        for (std::uint64_t i = 0; i < 500; ++i) {
            const Vec3 center = scale * Vec3{random.uniform(4 * i, -1, 7), random.uniform(4 * i + 1, -4, 4),
                                             random.uniform(4 * i + 2, -4, 4)};
            if (distance(center, {3 * scale, 0, 0}) < 1.1 * scale) continue;
            const double away = closest_point(tree.view(), ball.set(), center, kAnyFar).distance;
            const double radius = random.uniform(4 * i + 3, 0.1, 0.9) * away;
            const Clearance found = fcl.clearance(sphere(center, radius), kAnyFar);
            REQUIRE(found.answer == Answer::found);
            worst = std::max(worst, std::abs(found.distance - (away - radius)) / scale);
            worst_point = std::max(worst_point,
                                   std::abs(distance(found.on_body, found.on_other) - found.distance) / scale);
        }
        CHECK(worst < 1e-12);
        CHECK(worst_point < 1e-9);
    }
}

TEST_CASE("capsules and boxes keep clear of a floor by the closed form", "[unit]") {
    const std::vector<Vec3> vertices = {{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}};
    const std::vector<Corners> triangles = {{0, 3, 2}, {0, 2, 1}};
    const FclClearance floor({vertices, triangles});
    ProbeBody capsule;
    capsule.shape = ProbeBody::Shape::capsule;
    capsule.center = {0.3, 2, -0.4};
    capsule.axes[1] = {0.8, 0.6, 0};
    capsule.axes[2] = {0.6, -0.8, 0};  // leaning: one end is 0.8 below the center
    capsule.axes[0] = cross(capsule.axes[1], capsule.axes[2]);
    capsule.size = {0.25, 0, 2};
    const Clearance found = floor.clearance(capsule, kAnyFar);
    REQUIRE(found.answer == Answer::found);
    CHECK(found.distance == Approx(2 - 0.8 - 0.25).epsilon(1e-6));  // GJK ends at its tolerance
    ProbeBody box;
    box.shape = ProbeBody::Shape::box;
    box.center = {0.3, 2, -0.4};
    box.size = {1, 0.5, 2};
    CHECK(floor.clearance(box, kAnyFar).distance == Approx(1.75).epsilon(1e-6));
    CHECK(floor.clearance(box, 1.0).answer == Answer::nothing);
    box.center.y = 0.1;
    CHECK(floor.clearance(box, kAnyFar).answer == Answer::found);
    CHECK(floor.clearance(box, kAnyFar).distance == 0);
}

TEST_CASE("two bodies are apart by the closed form, small and large", "[unit]") {
    for (const double scale : {1e-8, 1.0, 1e6}) {
        CAPTURE(scale);
        const ProbeBody ball = sphere({scale, 0, 0}, 0.5 * scale);
        ProbeBody capsule = sphere({5 * scale, 3 * scale, 0}, 0.25 * scale);
        capsule.shape = ProbeBody::Shape::capsule;
        capsule.size.z = 4 * scale;  // upright to the line between them
        ProbeBody box;
        box.shape = ProbeBody::Shape::box;
        box.center = {4 * scale, -4 * scale, 0.1 * scale};
        box.axes = {{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}};
        box.size = {scale, scale, scale};
        struct Pair {
            ProbeBody a, b;
            double distance;
        };
        const double to_face = 5 - 0.5 - 0.5;  // the box is turned so that a face looks at the ball
        for (const auto& [a, b, expected] :
             {Pair{ball, sphere({4 * scale, 4 * scale, 0}, scale), 3.5 * scale},
              Pair{ball, capsule, (5 - 0.75) * scale}, Pair{capsule, ball, (5 - 0.75) * scale},
              Pair{ball, box, to_face * scale}, Pair{box, ball, to_face * scale}}) {
            const Clearance found = body_clearance(a, b);
            REQUIRE(found.answer == Answer::found);
            CHECK(found.distance == Approx(expected).epsilon(1e-5));  // GJK ends at its tolerance
            CHECK(distance(found.on_body, found.on_other) == Approx(expected).epsilon(1e-5));
        }
        const Clearance overlap = body_clearance(ball, sphere({1.5 * scale, 0, 0}, scale));
        CHECK(overlap.answer == Answer::found);
        CHECK(overlap.distance == 0);
    }
}

TEST_CASE("a body that means nothing is refused", "[unit]") {
    const auto ball = rough_ball(4, 1, {});
    const FclClearance fcl(ball.set());
    const double nan = std::nan("");
    CHECK(fcl.clearance(sphere({nan, 0, 0}, 1), 1).answer == Answer::refused);
    CHECK(fcl.clearance(sphere({2, 0, 0}, nan), 1).answer == Answer::refused);
    CHECK(fcl.clearance(sphere({2, 0, 0}, 0), 1).answer == Answer::refused);
    CHECK(fcl.clearance(sphere({2, 0, 0}, 1), nan).answer == Answer::refused);
    ProbeBody turned = sphere({2, 0, 0}, 1);
    turned.axes[0] = {0, 1, 0};
    CHECK(fcl.clearance(turned, 1).answer == Answer::refused);
    CHECK(body_clearance(turned, turned).answer == Answer::refused);
}
