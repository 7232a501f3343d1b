// What a factorisation, a solve and settling cost on a taut web of 1974 particles, against Eigen's sparse LDL^T
// of the same matrix in the same process.

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>

#include "../modules/web/sample_webs.hpp"
#include "block_solver.hpp"
#include "conjugate_gradients.hpp"
#include "settle.hpp"
#include "spring_system.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::mass_spring;
using Matrix = Eigen::SparseMatrix<double>;

constexpr double kShift = 1e-3;  // N/m, as a step of 10 ms puts on the diagonal

struct TautWeb {
    web::Layout layout = web::test::thesis_layout();
    Network network = web::find_form(layout, web::test::default_silks(), 1e-8, 1e-6, web::test::kGravity);
    std::vector<double> diagonal = std::vector<double>(network.size(), kShift);
    std::vector<SymmetricBlock> blocks;

    TautWeb() {
        for (const Spring& s : network.springs) {
            const Vec3 l = layout.positions[s.a] - layout.positions[s.b];
            blocks.push_back(stiffness_block(l, tension_at(s, norm(l) - s.rest_length), true));
        }
    }
};

const TautWeb& taut_web() {
    static const TautWeb web;
    return web;
}

/// The same matrix, free particles only.
Matrix eigen_matrix(const TautWeb& web) {
    std::vector<int> row(web.network.size(), -1);
    int count = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (web.network.fixed[i] == 0) row[i] = 3 * count++;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](int at, int beside, double sign, const SymmetricBlock& b) {
        const double full[3][3] = {{b.xx, b.xy, b.xz}, {b.xy, b.yy, b.yz}, {b.xz, b.yz, b.zz}};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) entries.emplace_back(at + i, beside + j, sign * full[i][j]);
    };
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] >= 0) add(row[i], row[i], 1, {kShift, 0, 0, kShift, 0, kShift});
    for (std::size_t i = 0; i < web.blocks.size(); ++i) {
        const int a = row[web.network.springs[i].a], b = row[web.network.springs[i].b];
        if (a >= 0) add(a, a, 1, web.blocks[i]);
        if (b >= 0) add(b, b, 1, web.blocks[i]);
        if (a >= 0 && b >= 0) {
            add(a, b, -1, web.blocks[i]);
            add(b, a, -1, web.blocks[i]);
        }
    }
    Matrix matrix(3 * count, 3 * count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

void factorize_blocks(benchmark::State& state) {
    BlockSolver solver(BlockPattern(taut_web().network));
    for (auto _ : state) benchmark::DoNotOptimize(solver.factorize(taut_web().diagonal, taut_web().blocks));
}

void factorize_eigen(benchmark::State& state) {
    const Matrix matrix = eigen_matrix(taut_web());
    Eigen::SimplicialLDLT<Matrix> solver;
    solver.analyzePattern(matrix);
    for (auto _ : state) solver.factorize(matrix);
}

void solve_blocks(benchmark::State& state) {
    BlockSolver solver(BlockPattern(taut_web().network));
    solver.factorize(taut_web().diagonal, taut_web().blocks);
    std::vector<Vec3> u(taut_web().network.size());
    for (auto _ : state) solver.solve(taut_web().layout.positions, u);
}

void solve_eigen(benchmark::State& state) {
    const Matrix matrix = eigen_matrix(taut_web());
    Eigen::SimplicialLDLT<Matrix> solver(matrix);
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(matrix.rows());
    Eigen::VectorXd u;
    for (auto _ : state) benchmark::DoNotOptimize(u = solver.solve(right));
}

void solve_conjugate_gradients(benchmark::State& state) {
    ConjugateGradients solver(taut_web().network);
    solver.factorize(taut_web().diagonal, taut_web().blocks);
    std::vector<Vec3> u(taut_web().network.size());
    for (auto _ : state) solver.solve(taut_web().layout.positions, u);
    state.counters["iterations"] = static_cast<double>(solver.iterations());
}

/// From rest in still air to rest in wind, the pattern's analysis included.
void settle_in_wind(benchmark::State& state) {
    const std::vector<Vec3> wind(taut_web().network.size(), Vec3{0, 0, 2e-6});
    SpringSystem system(taut_web().network, nullptr);
    system.set_surroundings({web::test::kGravity, 1e-8, wind});
    Settlement found;
    for (auto _ : state) {
        std::vector<Vec3> x = taut_web().layout.positions;
        found = settle(system, x);
    }
    state.counters["iterations"] = static_cast<double>(found.iterations);
    state.counters["residual_N"] = found.residual;
}

BENCHMARK(factorize_eigen)->Unit(benchmark::kMillisecond);
BENCHMARK(factorize_blocks)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_eigen)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_blocks)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_conjugate_gradients)->Unit(benchmark::kMillisecond);
BENCHMARK(settle_in_wind)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
