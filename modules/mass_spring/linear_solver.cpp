#include "linear_solver.hpp"

#include "block_solver.hpp"
#include "conjugate_gradients.hpp"

namespace orbweaver::mass_spring {

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, const Network& network) {
    constexpr std::size_t kMostForCholesky = 50'000;
    const bool factor = kind == LinearSolverKind::cholesky ||
                        (kind == LinearSolverKind::automatic && network.size() <= kMostForCholesky);
    if (factor) return std::make_unique<BlockSolver>(network);
    return std::make_unique<ConjugateGradients>(network);
}

}  // namespace orbweaver::mass_spring
