#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "network.hpp"
#include "orbweaver/vec3.hpp"
#include "symmetric_block.hpp"

namespace orbweaver::mass_spring {

/// Solves A u = b over the free particles of a network, where A has a multiple of the identity per particle
/// and, per spring, a symmetric 3x3 block B with + at its ends' diagonals and - beside. The pattern is ordered
/// (approximate minimum degree on particles) and analysed once; the factorisation is a sparse LDL^T.
class BlockSolver {
public:
    explicit BlockSolver(const Network& network);
    ~BlockSolver();

    /// `diagonal` per particle, `blocks` per spring. False when A is not positive definite; then the factors
    /// serve no solve.
    bool factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks);
    /// u is zero at fixed particles.
    void solve(std::span<const Vec3> b, std::span<Vec3> u);
    std::size_t memory_bytes() const noexcept;

private:
    struct Factors;
    /// Where a spring's block is added: at the diagonals of its ends, a the further up, and beside them.
    struct Place {
        std::int32_t a = -1;  ///< free particle, permuted; -1: fixed
        std::int32_t b = -1;
        std::int32_t beside = -1;  ///< b's place among the neighbors of a
    };

    void order(const Network& network);
    /// Per free particle, those further down that a spring joins it to.
    using Neighbors = std::vector<std::vector<std::int32_t>>;
    Neighbors find_neighbors(const Network& network) const;
    void make_pattern(const Neighbors& below);
    void place_springs(const Network& network, const Neighbors& below);
    void add_diagonal(std::int32_t particle, const SymmetricBlock& block) noexcept;
    void add_beside(const Place& place, const SymmetricBlock& block) noexcept;

    std::vector<std::int32_t> position_;  ///< of each particle among the free ones, permuted; -1: fixed
    std::size_t free_ = 0;
    std::vector<Place> places_;
    std::unique_ptr<Factors> factors_;
};

}  // namespace orbweaver::mass_spring
