#pragma once

#include <vector>

#include "linear_solver.hpp"

namespace orbweaver::mass_spring {

/// Conjugate gradients without a matrix, preconditioned by each particle's own 3x3 block (Hestenes and Stiefel
/// 1952). Ends where the residual, measured by the preconditioner's inverse, is 1e-10 of what it began with: a
/// measure that moves with masses and stiffnesses, where a tolerance in newtons would be met by any u once the
/// problem is small, and by none once it is stiff. Takes memory of the order of the network, and more steps the
/// stiffer the problem.
class ConjugateGradients final : public LinearSolver {
public:
    /// `network` must outlive it.
    explicit ConjugateGradients(const Network& network);

    bool factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) override;
    void solve(std::span<const Vec3> b, std::span<Vec3> u) override;
    double factorize_seconds() const noexcept override;
    double solve_seconds() const noexcept override;
    std::size_t memory_bytes() const noexcept override;

    std::size_t iterations() const noexcept { return iterations_; }  ///< of the last solve

private:
    void apply(std::span<const Vec3> in, std::span<Vec3> out) const noexcept;
    void precondition(std::span<const Vec3> in, std::span<Vec3> out) const noexcept;
    bool iterate(std::span<const Vec3> b, std::span<Vec3> u);

    const Network* network_;
    std::vector<double> diagonal_;         ///< per particle
    std::vector<SymmetricBlock> blocks_;   ///< per spring
    std::vector<SymmetricBlock> inverse_;  ///< per particle, of its own block
    std::vector<Vec3> residual_, step_, preconditioned_, image_;
    std::size_t iterations_ = 0;
};

}  // namespace orbweaver::mass_spring
