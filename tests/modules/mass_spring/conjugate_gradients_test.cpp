#include "conjugate_gradients.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "block_solver.hpp"
#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

std::vector<SymmetricBlock> blocks_of(const Body& body, double scale, bool clamped) {
    std::vector<SymmetricBlock> blocks;
    for (const Spring& s : body.network.springs)
        blocks.push_back(scale * bodies::stiffness_block(body, s, clamped));
    return blocks;
}

}  // namespace

TEST_CASE("conjugate gradients find what a factorisation finds, however stiff and however small", "[unit]") {
    // A tolerance in newtons would pass u = 0 for the small ones, and stop far too early for the stiff ones.
    for (Body body : {bodies::ragged_web(0), bodies::tangle(60, 0)}) {
        body.network.fixed[0] = body.network.fixed[9] = 1;
        ConjugateGradients iterative(body.network);
        BlockSolver direct(BlockPattern(body.network));
        for (const double stiffness : {1e-12, 1e-4, 1.0, 1e4, 1e12})
            for (const double load : {1e-15, 1.0, 1e9}) {
                CAPTURE(stiffness, load);
                const auto blocks = blocks_of(body, stiffness, true);
                const std::vector<double> diagonal(body.x.size(), 1e-3 * stiffness);
                REQUIRE(iterative.factorize(diagonal, blocks));
                REQUIRE(direct.factorize(diagonal, blocks));
                std::vector<Vec3> b = body.v, found(b.size()), expected(b.size());
                for (Vec3& each : b) each = load * each;
                iterative.solve(b, found);
                direct.solve(b, expected);
                double largest = 0, worst = 0;
                for (std::size_t i = 0; i < b.size(); ++i) {
                    largest = std::max(largest, norm(expected[i]));
                    worst = std::max(worst, distance(found[i], expected[i]));
                }
                CHECK(largest > 0);
                CHECK(worst <= 1e-7 * largest);
                CHECK(found[9] == Vec3{});
                CHECK(iterative.iterations() > 10);
            }
    }
}

TEST_CASE("no load is no way", "[unit]") {
    const Body body = bodies::bead_string(10, 0.01, 1, 100, 0.1);
    ConjugateGradients solver(body.network);
    REQUIRE(solver.factorize(std::vector<double>(12, 1.0), blocks_of(body, 1, true)));
    std::vector<Vec3> u(12, Vec3{1, 1, 1});
    solver.solve(std::vector<Vec3>(12), u);
    for (const Vec3& each : u) CHECK(each == Vec3{});
    CHECK(solver.iterations() == 0);
    CHECK(solver.memory_bytes() > 12 * sizeof(SymmetricBlock));
}

TEST_CASE("where the matrix is not positive definite there is no answer, and it is told", "[extreme]") {
    const Body body = bodies::bead_string(3, 0.01, 1, 1, -0.005);  // compressed: it would buckle
    ConjugateGradients solver(body.network);
    std::vector<Vec3> u(body.x.size());
    const std::vector<Vec3> across(body.x.size(), Vec3{0, 1, 0});
    const bool made = solver.factorize(std::vector<double>(body.x.size()), blocks_of(body, 1, false));
    if (made) solver.solve(across, u);
    CHECK((!made || std::isnan(u[1].y)));
    CHECK_FALSE(solver.factorize(std::vector<double>(body.x.size(), std::nan("")), blocks_of(body, 1, true)));
}
