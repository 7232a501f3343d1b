#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "block_pattern.hpp"
#include "network.hpp"
#include "orbweaver/vec3.hpp"
#include "symmetric_block.hpp"

namespace orbweaver::mass_spring {

/// Solves A u = b over the free particles of a network, where A has a multiple of the identity per particle
/// and, per spring, a symmetric 3x3 block B with + at its ends' diagonals and - beside: by Cholesky's
/// factorisation A = L L^T, block column by block column, on a pattern that is worked out once.
///
/// Its own, since a general sparse factorisation meets one number at a time: here every index serves nine, four
/// lanes wide (README, "Solving").
class BlockSolver {
public:
    explicit BlockSolver(const Network& network);

    /// `diagonal` per particle, `blocks` per spring. False when A is not positive definite; then the factors
    /// serve no solve.
    bool factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks);
    /// u is zero at fixed particles.
    void solve(std::span<const Vec3> b, std::span<Vec3> u);
    std::size_t memory_bytes() const noexcept;

    std::size_t blocks() const noexcept { return pattern_.blocks(); }  ///< of the factor
    std::size_t updates() const noexcept {
        return pattern_.targets().size();
    }  ///< of blocks, by a factorisation

private:
    void assemble(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) noexcept;
    void add(std::int32_t block, double sign, const SymmetricBlock& b) noexcept;

    BlockPattern pattern_;
    std::vector<double> factor_;  ///< blocks by columns of three numbers and a zero; diagonal ones inverted
    std::vector<double> right_;   ///< three numbers and a zero per column
};

}  // namespace orbweaver::mass_spring
