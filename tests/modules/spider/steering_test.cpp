#include "steering.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

constexpr double kFrame = 1.0 / 60;

Agent agent_at(const Vec3& position, const Vec3& velocity = {}) { return {position, velocity, {0, 1, 0}, 0.5}; }

/// Moves an agent on flat land by what a behavior wishes.
template <class Behavior>
Agent run(Agent agent, double seconds, Behavior behavior) {
    for (int i = 0; i < std::lround(seconds / kFrame); ++i) {
        const Wish wish{behavior(agent), 1};
        agent.velocity = accelerate(agent, control(agent, blend(agent, {&wish, 1}), 0.1, 5), kFrame);
        agent.position += kFrame * agent.velocity;
    }
    return agent;
}

}  // namespace

TEST_CASE("who seeks comes by, who flees is gone, and nobody leaves the plane or goes too fast", "[unit]") {
    const Vec3 target{1, 0.3, 1};
    const Agent seeker = run(agent_at({}), 2.7, [&](const Agent& a) { return seek(a, target); });
    CHECK(distance(seeker.position, {1, 0, 1}) < 0.2);
    CHECK(seeker.position.y == 0);
    const Agent fled = run(agent_at({}), 4, [&](const Agent& a) { return flee(a, target); });
    CHECK(distance(fled.position, {1, 0, 1}) > 3);
    CHECK(norm(fled.velocity) <= 0.5 * (1 + 1e-12));
    CHECK(dot(fled.position, {1, 0, 1}) < 0);
}

TEST_CASE("who arrives stands there", "[unit]") {
    const Agent there = run(agent_at({}), 10, [](const Agent& a) { return arrive(a, {1, 0, 0}, 0.4); });
    CHECK(distance(there.position, {1, 0, 0}) < 1e-3);
    CHECK(norm(there.velocity) < 1e-3);
}

TEST_CASE("a pursuer heads for where its quarry will be", "[unit]") {
    const Agent quarry = agent_at({1, 0, 0}, {0, 0, 0.3});
    const Vec3 way = pursue(agent_at({}), quarry, 10);
    // 1 m at 0.5 m/s: 2 s, in which the quarry comes 0.6 m far.
    CHECK(way.z / way.x == Approx(0.6).epsilon(1e-12));
    CHECK(evade(agent_at({}), quarry, 10) == -way);
    const Vec3 soon = pursue(agent_at({}), quarry, 1);
    CHECK(soon.z / soon.x == Approx(0.3).epsilon(1e-12));
}

TEST_CASE("a path is followed to its end", "[unit]") {
    const std::vector<Vec3> path{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    double farthest = 0;
    const Agent there = run(agent_at({0, 0, 0.1}), 12, [&](const Agent& a) {
        const double off = std::min({a.position.x > 1 ? a.position.x - 1 : std::abs(a.position.z),
                                     std::abs(a.position.x - 1), std::abs(a.position.z - 1)});
        farthest = std::max(farthest, off);
        return follow_path(a, path, 0.2);
    });
    CHECK(distance(there.position, {0, 0, 1}) < 0.01);
    CHECK(farthest < 0.2);
    CHECK(follow_path(agent_at({}), {}, 0.2) == Vec3{});
    CHECK(distance(follow_path(agent_at({}), std::array<Vec3, 1>{{{1, 0, 0}}}, 0.2), {0.5, 0, 0}) < 1e-15);
}

TEST_CASE("obstacles are passed on the nearer side, and dead ahead too", "[unit]") {
    for (const double beside : {0.0, 0.05, -0.05}) {
        const std::vector<Obstacle> obstacles{{{1, 0, beside}, 0.2}, {{5, 0, 0}, 0.2}};
        double nearest = 10;
        const Agent past = run(agent_at({}, {0.5, 0, 0}), 5, [&](const Agent& a) {
            nearest = std::min(nearest, distance(a.position, obstacles[0].center));
            const Vec3 away = avoid_obstacles(a, obstacles, 1.5);
            return away == Vec3{} ? seek(a, {3, 0, 0}) : away;
        });
        CHECK(past.position.x > 1.5);
        CHECK(nearest > 0.2);
    }
    CHECK(avoid_obstacles(agent_at({}), std::array<Obstacle, 1>{{{{0.1, 0, 0}, 0.5}}}, 1) == Vec3{});
    CHECK(avoid_obstacles(agent_at({}, {-0.5, 0, 0}), std::array<Obstacle, 1>{{{{1, 0, 0}, 0.2}}}, 9) ==
          Vec3{});
}

TEST_CASE("neighbors are kept at a distance, the nearer the harder", "[unit]") {
    const std::array<Vec3, 1> near{{{0.05, 0, 0}}}, far{{{0.15, 0, 0}}}, gone{{{0.3, 0, 0}}}, same{{{0, 0, 0}}};
    const double hard = norm(keep_apart(agent_at({}), near, 0.2)),
                 soft = norm(keep_apart(agent_at({}), far, 0.2));
    CHECK(hard == Approx(0.75 * 0.5));
    CHECK(soft == Approx(0.25 * 0.5));
    CHECK(keep_apart(agent_at({}), near, 0.2).x < 0);
    CHECK(keep_apart(agent_at({}), gone, 0.2) == Vec3{});
    CHECK(keep_apart(agent_at({}), same, 0.2) == Vec3{});
}

TEST_CASE("wishes count by their weights, those without a wish not at all, and force is limited", "[unit]") {
    const Agent agent = agent_at({}, {0.1, 0, 0});
    const std::array<Wish, 3> wishes{{{{0.3, 0, 0}, 1}, {{0, 0, 0.4}, 3}, {{}, 100}}};
    const Vec3 signal = control(agent, blend(agent, wishes), 0.5, 100);
    CHECK(signal.x == Approx((0.075 - 0.1) / 0.5));
    CHECK(signal.z == Approx(0.3 / 0.5));
    CHECK(norm(control(agent, blend(agent, wishes), 0.5, 0.2)) == Approx(0.2));
    CHECK(control(agent, blend(agent, {}), 0.5, 1) == Vec3{});
}

TEST_CASE("a sharp corner nearby slows, a gentle or distant one does not", "[unit]") {
    CHECK(caution(90, 0, 0.1, 0.3) == Approx(0.3));
    CHECK(caution(180, 0, 0.1, 0.3) == Approx(0.3));
    CHECK(caution(90, 0.05, 0.1, 0.3) == Approx(0.65));
    CHECK(caution(90, 0.1, 0.1, 0.3) == 1);
    CHECK(caution(0, 0, 0.1, 0.3) == 1);
}
