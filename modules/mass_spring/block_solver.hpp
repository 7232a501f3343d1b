#pragma once

#include <vector>

#include "block_pattern.hpp"
#include "linear_solver.hpp"

namespace orbweaver::mass_spring {

/// By Cholesky's factorisation A = L L^T, block column by block column, on a pattern that is worked out once.
///
/// Its own, since a general sparse factorisation meets one number at a time: here every index serves nine, four
/// lanes wide (README, "Solving").
class BlockSolver final : public LinearSolver {
public:
    explicit BlockSolver(BlockPattern pattern);

    bool factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) override;
    void solve(std::span<const Vec3> b, std::span<Vec3> u) override;
    double factorize_seconds() const noexcept override;
    double solve_seconds() const noexcept override;
    std::size_t memory_bytes() const noexcept override;

private:
    void assemble(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) noexcept;
    void add(std::int32_t block, double sign, const SymmetricBlock& b) noexcept;

    BlockPattern pattern_;
    std::vector<double> factor_;  ///< blocks by columns of three numbers and a zero; diagonal ones inverted
    std::vector<double> right_;   ///< three numbers and a zero per column
};

}  // namespace orbweaver::mass_spring
