#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "network.hpp"
#include "orbweaver/vec3.hpp"
#include "symmetric_block.hpp"

namespace orbweaver::mass_spring {

/// Solves A u = b over the free particles of a network, where A has a multiple of the identity per particle
/// and, per spring, a symmetric 3x3 block B with + at its ends' diagonals and - beside.
class LinearSolver {
public:
    virtual ~LinearSolver() = default;

    /// `diagonal` per particle, `blocks` per spring. False where A was found not to be positive definite; then
    /// there is nothing to solve with.
    virtual bool factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) = 0;
    /// u is zero at fixed particles, and not a number where no solution was found.
    virtual void solve(std::span<const Vec3> b, std::span<Vec3> u) = 0;

    virtual double factorize_seconds() const noexcept = 0;  ///< see SpringSystem::work_seconds()
    virtual double solve_seconds() const noexcept = 0;      ///< of the last solve
    virtual std::size_t memory_bytes() const noexcept = 0;
};

enum class LinearSolverKind : std::uint8_t {
    automatic,  ///< cholesky where its factor, counted before it is made, is of at most 4 million blocks and
                ///< 134 million updates, some 1 GB; conjugate_gradients beyond
    cholesky,   ///< whatever it takes
    conjugate_gradients
};
/// By the name that scenes give it; any other is conjugate_gradients.
inline LinearSolverKind linear_solver_named(std::string_view name) noexcept {
    if (name == "cholesky") return LinearSolverKind::cholesky;
    return name == "auto" ? LinearSolverKind::automatic : LinearSolverKind::conjugate_gradients;
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, const Network& network);

}  // namespace orbweaver::mass_spring
