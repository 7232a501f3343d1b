#include "leg_solver.hpp"

#include <cmath>
#include <limits>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

TEST_CASE("solvers are found by their names", "[unit]") {
    CHECK(leg_solvers().size() == 4);
    for (const LegSolver& solver : leg_solvers()) CHECK(find_leg_solver(solver.name) == &solver);
    CHECK(find_leg_solver("simplex") == nullptr);
}

TEST_CASE("no solver passes a limit it keeps, or leaves the numbers, wherever targets are", "[unit]") {
    const Leg leg = creature("huntsman").limbs[0].leg;
    LegSolverOptions options;
    options.restarts = 1;
    for (const LegSolver& solver : leg_solvers()) {
        INFO(solver.name);
        const RandomStream random(5, "targets");
        LegPose pose = rest_pose(leg);
        int blocked = 0;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const auto draw = [&](std::uint64_t k) {
                return leg.length * random.uniform(3 * i + k, -1.2, 1.2);
            };
            const LegTarget target{{draw(0), draw(1), draw(2)}};
            const LegResult result = solver.solve(leg, target, options, pose);
            blocked += result.answer == LegAnswer::blocked;
            if (solver.keeps_limits) REQUIRE(violation(leg, pose) == 0);
            for (const double angle : pose) REQUIRE(std::isfinite(angle));
            REQUIRE(std::isfinite(result.error));
            REQUIRE((result.answer == LegAnswer::out_of_reach) == (norm(target.position) > leg.length));
            if (result.answer == LegAnswer::reached)
                REQUIRE(distance(foot_position(leg, pose), target.position) <= 1.001e-6 * leg.length);
        }
        CHECK(blocked > 0);
    }
}

TEST_CASE("every solver has an answer for targets that have none", "[unit]") {
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const LegSolver& solver : leg_solvers())
        for (const Limb& limb : creature("huntsman").limbs) {
            INFO(solver.name << ", " << limb.name);
            const Leg& leg = limb.leg;
            const LegPose rest = rest_pose(leg);
            LegPose pose = rest;
            CHECK(solver.solve(leg, {{0, inf, 0}}, {}, pose).answer == LegAnswer::refused);
            CHECK(pose == rest);
            const LegResult far = solver.solve(leg, {{1e308, -1e308, 1e307}}, {}, pose);
            CHECK(far.answer == LegAnswer::out_of_reach);
            CHECK(std::isfinite(far.error));
            const LegResult root = solver.solve(leg, {}, {}, pose);
            CHECK((root.answer == LegAnswer::reached || root.answer == LegAnswer::blocked));
            pose = {};
            const LegResult in_line =
                solver.solve(leg, {{0.8 * leg.length, 0, 0}, foot_frame(leg, rest)}, {}, pose);
            CHECK((solver.orients || in_line.answer == LegAnswer::reached));
            for (const double angle : pose) CHECK(std::isfinite(angle));
        }
}
