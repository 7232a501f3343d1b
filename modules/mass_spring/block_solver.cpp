#include "block_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lanes.hpp"
#include "orbweaver/targets.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr std::size_t kBlock = 12;  ///< doubles: three columns of four lanes, the last of which stays zero
constexpr std::size_t kColumn = 4;

ORBWEAVER_INLINE Lanes broadcast(double s) noexcept { return Lanes{s, s, s, s}; }

/// A block's columns.
struct Block {
    Lanes x, y, z;
};

ORBWEAVER_INLINE Block load_block(const double* from) noexcept {
    return {load(from), load(from + 4), load(from + 8)};
}

ORBWEAVER_INLINE void store_block(double* to, const Block& b) noexcept {
    store(to, b.x);
    store(to + 4, b.y);
    store(to + 8, b.z);
}

/// B u
ORBWEAVER_INLINE Lanes times(const Block& b, const double* u) noexcept {
    return b.x * broadcast(u[0]) + b.y * broadcast(u[1]) + b.z * broadcast(u[2]);
}

ORBWEAVER_INLINE double sum(const Lanes& s) noexcept { return s[0] + s[1] + s[2]; }

/// The lower triangle of a positive definite block, factorised, its diagonal inverted; false where it is not.
ORBWEAVER_INLINE bool factorize_diagonal(double* d) noexcept {
    if (!(d[0] > 0)) return false;
    d[0] = 1 / std::sqrt(d[0]);
    d[1] *= d[0];
    d[2] *= d[0];
    const double yy = d[5] - d[1] * d[1];
    if (!(yy > 0)) return false;
    d[5] = 1 / std::sqrt(yy);
    d[6] = (d[6] - d[2] * d[1]) * d[5];
    const double zz = d[10] - d[2] * d[2] - d[6] * d[6];
    if (!(zz > 0) || !(zz < HUGE_VAL)) return false;
    d[10] = 1 / std::sqrt(zz);
    return true;
}

/// B D^-T, with D as factorize_diagonal() leaves it.
ORBWEAVER_INLINE Block divide(const Block& b, const double* d) noexcept {
    const Lanes x = b.x * broadcast(d[0]);
    const Lanes y = (b.y - x * broadcast(d[1])) * broadcast(d[5]);
    return {x, y, (b.z - x * broadcast(d[2]) - y * broadcast(d[6])) * broadcast(d[10])};
}

/// Row r of a block, each number in all lanes.
ORBWEAVER_INLINE Block broadcast_row(const double* block, std::size_t r) noexcept {
    return {broadcast(block[r]), broadcast(block[r + 4]), broadcast(block[r + 8])};
}

ORBWEAVER_INLINE Lanes combine(const Block& b, const Block& weights) noexcept {
    return b.x * weights.x + b.y * weights.y + b.z * weights.z;
}

/// What column k takes from all later ones: block (i, j) loses L_ik L_jk^T. Returns the targets after its own.
ORBWEAVER_INLINE const std::int32_t* eliminate(const double* column, std::size_t count,
                                               const std::int32_t* target, double* factor) noexcept {
    for (std::size_t j = 0; j < count; ++j) {
        const double* across = column + j * kBlock;
        const Block x = broadcast_row(across, 0), y = broadcast_row(across, 1), z = broadcast_row(across, 2);
        for (std::size_t i = j; i < count; ++i) {
            const Block b = load_block(column + i * kBlock);
            double* to = factor + static_cast<std::size_t>(*target++) * kBlock;
            const Block old = load_block(to);
            store_block(to, {old.x - combine(b, x), old.y - combine(b, y), old.z - combine(b, z)});
        }
    }
    return target;
}

ORBWEAVER_INLINE bool factorize_columns(const BlockPattern& pattern, double* factor) noexcept {
    const std::int32_t* target = pattern.targets().data();
    for (std::size_t k = 0; k < pattern.columns(); ++k) {
        double* diagonal = factor + k * kBlock;
        if (!factorize_diagonal(diagonal)) return false;
        double* column = factor + pattern.first_block(k) * kBlock;
        const std::size_t count = pattern.rows(k).size();
        for (std::size_t i = 0; i < count; ++i)
            store_block(column + i * kBlock, divide(load_block(column + i * kBlock), diagonal));
        target = eliminate(column, count, target, factor);
    }
    return true;
}

/// L y = b, in place.
ORBWEAVER_INLINE void substitute_forward(const BlockPattern& pattern, const double* factor,
                                         double* right) noexcept {
    for (std::size_t k = 0; k < pattern.columns(); ++k) {
        const double* d = factor + k * kBlock;
        double* y = right + k * kColumn;
        y[0] *= d[0];
        y[1] = (y[1] - d[1] * y[0]) * d[5];
        y[2] = (y[2] - d[2] * y[0] - d[6] * y[1]) * d[10];
        const double* block = factor + pattern.first_block(k) * kBlock;
        for (const std::int32_t row : pattern.rows(k)) {
            double* to = right + static_cast<std::size_t>(row) * kColumn;
            store(to, load(to) - times(load_block(block), y));
            block += kBlock;
        }
    }
}

/// L^T u = y, in place.
ORBWEAVER_INLINE void substitute_backward(const BlockPattern& pattern, const double* factor,
                                          double* right) noexcept {
    for (std::size_t k = pattern.columns(); k-- > 0;) {
        Block taken{};
        const double* block = factor + pattern.first_block(k) * kBlock;
        for (const std::int32_t row : pattern.rows(k)) {
            const Lanes u = load(right + static_cast<std::size_t>(row) * kColumn);
            const Block b = load_block(block);
            taken = {taken.x + b.x * u, taken.y + b.y * u, taken.z + b.z * u};
            block += kBlock;
        }
        const double* d = factor + k * kBlock;
        double* y = right + k * kColumn;
        y[2] = (y[2] - sum(taken.z)) * d[10];
        y[1] = (y[1] - sum(taken.y) - d[6] * y[2]) * d[5];
        y[0] = (y[0] - sum(taken.x) - d[1] * y[1] - d[2] * y[2]) * d[0];
    }
}

}  // namespace

BlockSolver::BlockSolver(BlockPattern pattern)
    : pattern_(std::move(pattern)), factor_(pattern_.blocks() * kBlock), right_(pattern_.columns() * kColumn) {}

void BlockSolver::add(std::int32_t block, double sign, const SymmetricBlock& b) noexcept {
    double* to = factor_.data() + static_cast<std::size_t>(block) * kBlock;
    const Block old = load_block(to);
    const Lanes s = broadcast(sign);
    store_block(to, {old.x + s * Lanes{b.xx, b.xy, b.xz, 0}, old.y + s * Lanes{b.xy, b.yy, b.yz, 0},
                     old.z + s * Lanes{b.xz, b.yz, b.zz, 0}});
}

void BlockSolver::assemble(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) noexcept {
    std::fill(factor_.begin(), factor_.end(), 0.0);
    for (std::size_t i = 0; i < diagonal.size(); ++i)
        if (const std::int32_t column = pattern_.column_of(i); column >= 0)
            add(column, 1, {diagonal[i], 0, 0, diagonal[i], 0, diagonal[i]});
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const BlockPattern::Place& place = pattern_.places()[i];
        if (place.a >= 0) add(place.a, 1, blocks[i]);
        if (place.b >= 0) add(place.b, 1, blocks[i]);
        if (place.a >= 0) add(place.beside, -1, blocks[i]);
    }
}

bool BlockSolver::factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) {
    assemble(diagonal, blocks);
    return run_wide([this]() ORBWEAVER_ALWAYS_INLINE { return factorize_columns(pattern_, factor_.data()); });
}

void BlockSolver::solve(std::span<const Vec3> b, std::span<Vec3> u) {
    const auto at = [this](std::int32_t column) { return &right_[static_cast<std::size_t>(column) * kColumn]; };
    for (std::size_t i = 0; i < b.size(); ++i)
        if (const std::int32_t column = pattern_.column_of(i); column >= 0)
            store(at(column), Lanes{b[i].x, b[i].y, b[i].z, 0});
    run_wide([this]() ORBWEAVER_ALWAYS_INLINE {
        substitute_forward(pattern_, factor_.data(), right_.data());
        substitute_backward(pattern_, factor_.data(), right_.data());
    });
    for (std::size_t i = 0; i < u.size(); ++i) {
        const std::int32_t column = pattern_.column_of(i);
        u[i] = column < 0 ? Vec3{} : Vec3{at(column)[0], at(column)[1], at(column)[2]};
    }
}

double BlockSolver::factorize_seconds() const noexcept {
    constexpr double kUpdate = 4.6e-9, kSpring = 20e-9;
    return kUpdate * static_cast<double>(pattern_.targets().size()) +
           kSpring * static_cast<double>(pattern_.places().size());
}

double BlockSolver::solve_seconds() const noexcept {
    constexpr double kBlock = 7e-9, kParticle = 20e-9;
    return kBlock * static_cast<double>(pattern_.blocks()) +
           kParticle * static_cast<double>(pattern_.columns());
}

std::size_t BlockSolver::memory_bytes() const noexcept {
    return pattern_.memory_bytes() + (factor_.capacity() + right_.capacity()) * sizeof(double);
}

}  // namespace orbweaver::mass_spring
