#include "linear_solver.hpp"

#include <catch2/catch.hpp>

#include "block_solver.hpp"
#include "bodies.hpp"
#include "conjugate_gradients.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("the solver asked for is made, and one whose factor fits where it is not said", "[unit]") {
    const auto makes_factor = [](LinearSolverKind kind, const Network& network) {
        return dynamic_cast<BlockSolver*>(make_linear_solver(kind, network).get()) != nullptr;
    };
    const Network small = bodies::bead_string(10, 1, 1, 1, 0.1).network;
    CHECK(makes_factor(LinearSolverKind::cholesky, small));
    CHECK(makes_factor(LinearSolverKind::automatic, small));
    // Not how many particles there are matters, but how they hang together.
    CHECK(makes_factor(LinearSolverKind::automatic, bodies::bead_string(200'000, 1, 1, 1, 0.1).network));
    CHECK(makes_factor(LinearSolverKind::automatic, bodies::lattice(12, 0.1).network));
    CHECK_FALSE(makes_factor(LinearSolverKind::automatic, bodies::lattice(30, 0.1).network));
    CHECK_FALSE(makes_factor(LinearSolverKind::conjugate_gradients, small));
}

TEST_CASE("implicit methods come to the same motion with either solver", "[unit]") {
    for (const char* name : {"implicit_euler", "tr_bdf2"}) {
        bodies::Body one = bodies::ragged_web(0.1);
        bodies::Body other = one;
        for (auto [body, kind] : {std::pair(&one, LinearSolverKind::cholesky),
                                  std::pair(&other, LinearSolverKind::conjugate_gradients)}) {
            SpringSystem system(body->network, nullptr);
            system.set_surroundings({{0, -9.81, 0}, 0.1, {}});
            system.use_linear_solver(kind);
            Integrator(system, *find_method(name)).advance(body->x, body->v, 0.05, 10);
            CHECK(system.work_seconds() > 0);
        }
        for (std::size_t i = 0; i < one.x.size(); ++i) CHECK(distance(one.x[i], other.x[i]) < 1e-6);
        CHECK_FALSE(bodies::same_bits(one.x, other.x));
    }
}
