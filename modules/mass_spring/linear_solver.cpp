#include "linear_solver.hpp"

#include "block_solver.hpp"
#include "conjugate_gradients.hpp"

namespace orbweaver::mass_spring {

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, const Network& network) {
    // Some 100 bytes a block, 4 bytes and 4.6 ns an update: up to 1 GB, and 0.6 s a factorisation.
    constexpr FactorLimit kMost{std::size_t{1} << 22, std::size_t{1} << 27};
    if (kind == LinearSolverKind::conjugate_gradients) return std::make_unique<ConjugateGradients>(network);
    auto pattern = BlockPattern::within(network, kind == LinearSolverKind::automatic ? kMost : FactorLimit{});
    if (!pattern) return std::make_unique<ConjugateGradients>(network);
    return std::make_unique<BlockSolver>(*std::move(pattern));
}

}  // namespace orbweaver::mass_spring
