#include "wander.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

constexpr double kFrame = 1.0 / 60;

/// How sharply a walk turns, in rad a frame: on the mean, and the most of a frame.
struct Turning {
    double mean = 0, most = 0;
};

Turning walk(const WanderSettings& settings, std::uint64_t seed) {
    constexpr int kFrames = 6000;
    const RandomStream random(seed, "wander");
    Agent agent{{}, {0.1, 0, 0}, {0, 1, 0}, 0.1};
    Vec3 forward{1, 0, 0};
    WanderState state;
    Turning turning;
    for (int i = 0; i < kFrames; ++i) {
        const Wish wish{wander(agent, forward, settings, random, kFrame, state), 1};
        agent.velocity = accelerate(agent, control(agent, blend(agent, {&wish, 1}), 0.15, 10), kFrame);
        const Vec3 next = norm(agent.velocity) > 0 ? agent.velocity / norm(agent.velocity) : forward;
        const double turn = std::asin(std::min(1.0, norm(cross(forward, next))));
        turning.mean += turn / kFrames;
        turning.most = std::max(turning.most, turn);
        forward = next;
    }
    return turning;
}

}  // namespace

TEST_CASE("small frequent displacements make arcs, large rare ones make turns", "[unit]") {
    const Turning lizard = walk({1.5, 0.1, 60}, 1), spider = walk({0.6, 3, 0.7}, 1);
    CHECK(lizard.most < spider.most / 2);
    CHECK(lizard.mean > 0);
}

TEST_CASE("the wish is as fast as the creature, and in the surface's plane", "[unit]") {
    for (const bool on_ball : {true, false}) {
        const Agent agent{{}, {}, {0, 0, 1}, 0.2};
        const RandomStream random(3, "wander");
        WanderState state;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 wish = wander(agent, {0, 1, 0}, {1.2, 1, 20, on_ball}, random, kFrame, state);
            CHECK(wish.z == 0);
            CHECK(norm(wish) == Approx(0.2).epsilon(1e-12));
            CHECK(norm(state.point) == Approx(1).epsilon(1e-12));
            if (!on_ball) CHECK(state.point.z == 0);
        }
    }
}

TEST_CASE("a restored wanderer goes on as the one that never stopped", "[unit]") {
    const Agent agent{{}, {}, {0, 1, 0}, 0.2};
    const RandomStream random(3, "wander");
    const WanderSettings settings{1, 0.5, 10};
    WanderState whole, saved;
    for (int i = 0; i < 200; ++i) {
        if (i == 100) saved = whole;
        wander(agent, {1, 0, 0}, settings, random, kFrame, whole);
    }
    for (int i = 100; i < 200; ++i) wander(agent, {1, 0, 0}, settings, random, kFrame, saved);
    CHECK(saved.point == whole.point);
    CHECK(saved.draws == whole.draws);
}
