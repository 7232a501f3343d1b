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

TEST_CASE("a pursuer heads for where it meets its quarry", "[unit]") {
    const Agent quarry = agent_at({1, 0, 0}, {0, 0, 0.3});
    const Vec3 way = pursue(agent_at({}), quarry, 10);
    // 1 m across at sqrt(0.5^2 - 0.3^2) m/s: 2.5 s, in which the quarry comes 0.75 m far.
    CHECK(way.z / way.x == Approx(0.75).epsilon(1e-12));
    CHECK(evade(agent_at({}), quarry, 10) == -way);
    const Vec3 soon = pursue(agent_at({}), quarry, 1);
    CHECK(soon.z / soon.x == Approx(0.3).epsilon(1e-12));
    // Who is as fast is met where the ways' middles cross; who is faster and leaves, never.
    const Vec3 level = pursue(agent_at({}), agent_at({1, 0, 0}, {-0.3, 0, 0.4}), 10);
    CHECK(level.z / level.x == Approx(4.0 / 3).epsilon(1e-12));  // after 1/0.6 s
    const Vec3 late = pursue(agent_at({}), agent_at({1, 0, 0}, {0, 0, 2}), 10);
    CHECK(late.z / late.x == Approx(20).epsilon(1e-12));
}

TEST_CASE("a pursuer at full speed catches a quarry that goes straight on when it was foreseen", "[unit]") {
    for (const Vec3 velocity : {Vec3{0, 0, 0.3}, Vec3{0.4, 0, 0.1}, Vec3{-0.2, 0, 0.4}, Vec3{}}) {
        const Vec3 start{1, 0, 0};
        // |start + velocity t| = 0.5 t
        const double a = dot(velocity, velocity) - 0.25, b = dot(start, velocity);
        const double predicted = (-b - std::sqrt(b * b - a)) / a;
        constexpr double kStep = 1e-3;
        Agent agent = agent_at({});
        Agent quarry = agent_at(start, velocity);
        int steps = 0;
        for (; distance(agent.position, quarry.position) > 2 * 0.5 * kStep && steps < 100'000; ++steps) {
            agent.position += kStep * pursue(agent, quarry, 100);
            quarry.position += kStep * velocity;
        }
        CHECK(std::abs(steps * kStep - predicted) < 2e-2);  // the last 1 mm, at a closing speed of 0.05 m/s
    }
}

TEST_CASE("a path is followed to its end", "[unit]") {
    const std::vector<Vec3> path{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    double farthest = 0;
    const Agent there = run(agent_at({0, 0, 0.1}), 12, [&](const Agent& a) {
        const double off = std::min({a.position.x > 1 ? a.position.x - 1 : std::abs(a.position.z),
                                     std::abs(a.position.x - 1), std::abs(a.position.z - 1)});
        farthest = std::max(farthest, off);
        return follow_path(a, path, false, 0.2);
    });
    CHECK(distance(there.position, {0, 0, 1}) < 0.01);
    CHECK(farthest < 0.2);
    CHECK(follow_path(agent_at({}), {}, false, 0.2) == Vec3{});
    CHECK(distance(follow_path(agent_at({}), std::array<Vec3, 1>{{{1, 0, 0}}}, true, 0.2), {0.5, 0, 0}) <
          1e-15);
}

TEST_CASE("a loop is followed round and round", "[unit]") {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    int rounds = 0;
    double farthest = 0;
    Vec3 before{0, 0, 0.5};
    run(agent_at({0, 0, 0.5}), 40, [&](const Agent& a) {
        if (a.position.x < 0.5 && before.z > 0.5 && a.position.z <= 0.5) ++rounds;
        before = a.position;
        const double inside = std::min({a.position.x, 1 - a.position.x, a.position.z, 1 - a.position.z});
        farthest = std::max(farthest, std::abs(inside));
        return follow_path(a, square, true, 0.15);
    });
    CHECK(rounds >= 4);  // 20 m of a way of 4 m, less what corners are cut by
    CHECK(rounds <= 6);
    CHECK(farthest < 0.15);
    // From the last side it heads past the first corner.
    const Vec3 way = follow_path(agent_at({0, 0, 0.05}), square, true, 0.15);
    CHECK(way.x / way.z == Approx(-2).epsilon(1e-9));
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
    // What is beyond a wall, or above, is no obstacle.
    CHECK(avoid_obstacles(agent_at({}, {0.5, 0, 0}), std::array<Obstacle, 1>{{{{1, 0.3, 0}, 0.2}}}, 9) ==
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
