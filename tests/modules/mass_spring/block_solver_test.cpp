#include "block_solver.hpp"

#include <catch2/catch.hpp>

#include "bodies.hpp"
#include "spring_tangent.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

std::vector<SymmetricBlock> blocks_of(const Body& body, bool clamped) {
    std::vector<SymmetricBlock> blocks;
    for (const Spring& s : body.network.springs) blocks.push_back(bodies::stiffness_block(body, s, clamped));
    return blocks;
}

}  // namespace

TEST_CASE("solving undoes the tangent stiffness", "[unit]") {
    for (Body body : {bodies::ragged_web(0), bodies::tangle(60, 0)}) {
        for (Spring& s : body.network.springs) s.rest_length = 0.01;  // taut: positive definite
        body.network.fixed[0] = body.network.fixed[9] = body.network.fixed[30] = 1;
        BlockSolver solver(BlockPattern(body.network));
        const std::vector<double> shift(body.x.size(), 0.25);
        REQUIRE(solver.factorize(shift, blocks_of(body, false)));
        std::vector<Vec3> u(body.x.size()), back(body.x.size());
        solver.solve(body.v, u);
        const SpringSystem system(body.network, nullptr);
        SpringTangent(system, body.x).apply(1, 0, u, back);
        for (std::size_t i = 0; i < u.size(); ++i) {
            if (body.network.fixed[i] != 0)
                CHECK(u[i] == Vec3{});
            else
                CHECK(distance(back[i] + 0.25 * u[i], body.v[i]) < 1e-12);
        }
        CHECK(solver.memory_bytes() > 9 * sizeof(double) * body.network.springs.size());
    }
}

TEST_CASE("a matrix that is not positive definite is told", "[unit]") {
    Body body = bodies::bead_string(3, 0.01, 1, 1, -0.005);  // compressed: it would buckle
    BlockSolver solver(BlockPattern(body.network));
    const std::vector<double> none(body.x.size());
    CHECK_FALSE(solver.factorize(none, blocks_of(body, false)));
    const std::vector<double> little(body.x.size(), 1e-6);
    CHECK(solver.factorize(little, blocks_of(body, true)));
}

TEST_CASE("where everything is fixed there is nothing to solve", "[unit]") {
    Body body = bodies::oscillator(1, 1);
    body.network.fixed[1] = 1;
    BlockSolver solver(BlockPattern(body.network));
    CHECK(solver.factorize(std::vector<double>(2), blocks_of(body, false)));
    std::vector<Vec3> u(2, Vec3{1, 1, 1});
    solver.solve(body.x, u);
    CHECK(u[1] == Vec3{});
}
