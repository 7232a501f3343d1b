#include "block_solver.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

namespace orbweaver::mass_spring {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>;

struct BlockSolver::Factors {
    Matrix matrix;  ///< lower triangle
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<std::int32_t>> ldlt;
    Eigen::VectorXd right, solution;
};

BlockSolver::BlockSolver(const Network& network)
    : position_(network.size(), -1), factors_(std::make_unique<Factors>()) {
    order(network);
    const Neighbors below = find_neighbors(network);
    make_pattern(below);
    place_springs(network, below);
    factors_->ldlt.analyzePattern(factors_->matrix);
    factors_->right.resize(factors_->matrix.rows());
}

BlockSolver::~BlockSolver() = default;

void BlockSolver::order(const Network& network) {
    for (std::size_t i = 0; i < network.size(); ++i)
        if (network.fixed[i] == 0) position_[i] = static_cast<std::int32_t>(free_++);
    std::vector<Eigen::Triplet<double, std::int32_t>> joined;
    for (const Spring& s : network.springs) {
        const std::int32_t a = position_[s.a], b = position_[s.b];
        if (a < 0 || b < 0) continue;
        joined.emplace_back(a, b, 1.0);
        joined.emplace_back(b, a, 1.0);
    }
    const auto size = static_cast<std::int32_t>(free_);
    for (std::int32_t i = 0; i < size; ++i) joined.emplace_back(i, i, 1.0);
    Matrix graph(size, size);
    graph.setFromTriplets(joined.begin(), joined.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> inverse;
    Eigen::AMDOrdering<std::int32_t>()(graph, inverse);  // new place -> old place
    std::vector<std::int32_t> moved(free_);
    for (std::int32_t i = 0; i < size; ++i) moved[static_cast<std::size_t>(inverse.indices()[i])] = i;
    for (std::int32_t& position : position_)
        if (position >= 0) position = moved[static_cast<std::size_t>(position)];
}

BlockSolver::Neighbors BlockSolver::find_neighbors(const Network& network) const {
    Neighbors below(free_);
    for (const Spring& s : network.springs) {
        const auto [first, second] = std::minmax(position_[s.a], position_[s.b]);
        if (first >= 0) below[static_cast<std::size_t>(first)].push_back(second);
    }
    for (auto& neighbors : below) {
        std::sort(neighbors.begin(), neighbors.end());
        neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    }
    return below;
}

void BlockSolver::make_pattern(const Neighbors& below) {
    Matrix& matrix = factors_->matrix;
    const auto size = static_cast<std::int32_t>(3 * free_);
    std::size_t entries = 0;
    for (const auto& neighbors : below) entries += 6 + 9 * neighbors.size();
    matrix.resize(size, size);
    matrix.resizeNonZeros(static_cast<Eigen::Index>(entries));
    std::int32_t next = 0;
    for (std::int32_t column = 0; column < size; ++column) {
        const std::int32_t particle = column / 3;
        matrix.outerIndexPtr()[column] = next;
        for (std::int32_t row = column; row < 3 * particle + 3; ++row) matrix.innerIndexPtr()[next++] = row;
        for (const std::int32_t other : below[static_cast<std::size_t>(particle)])
            for (std::int32_t r = 0; r < 3; ++r) matrix.innerIndexPtr()[next++] = 3 * other + r;
    }
    matrix.outerIndexPtr()[size] = next;
}

void BlockSolver::place_springs(const Network& network, const Neighbors& below) {
    for (const Spring& s : network.springs) {
        const auto [first, second] = std::minmax(position_[s.a], position_[s.b]);
        std::int32_t beside = -1;
        if (first >= 0) {
            const auto& neighbors = below[static_cast<std::size_t>(first)];
            beside = static_cast<std::int32_t>(std::lower_bound(neighbors.begin(), neighbors.end(), second) -
                                               neighbors.begin());
        }
        places_.push_back({first, second, beside});
    }
}

void BlockSolver::add_diagonal(std::int32_t particle, const SymmetricBlock& block) noexcept {
    double* values = factors_->matrix.valuePtr();
    const std::int32_t* column = &factors_->matrix.outerIndexPtr()[3 * particle];
    values[column[0]] += block.xx;
    values[column[0] + 1] += block.xy;
    values[column[0] + 2] += block.xz;
    values[column[1]] += block.yy;
    values[column[1] + 1] += block.yz;
    values[column[2]] += block.zz;
}

void BlockSolver::add_beside(const Place& place, const SymmetricBlock& block) noexcept {
    const std::int32_t* column = &factors_->matrix.outerIndexPtr()[3 * place.a];
    const std::int32_t row = 3 * place.beside;
    double* x = &factors_->matrix.valuePtr()[column[0] + 3 + row];
    double* y = &factors_->matrix.valuePtr()[column[1] + 2 + row];
    double* z = &factors_->matrix.valuePtr()[column[2] + 1 + row];
    x[0] -= block.xx;
    x[1] -= block.xy;
    x[2] -= block.xz;
    y[0] -= block.xy;
    y[1] -= block.yy;
    y[2] -= block.yz;
    z[0] -= block.xz;
    z[1] -= block.yz;
    z[2] -= block.zz;
}

bool BlockSolver::factorize(std::span<const double> diagonal, std::span<const SymmetricBlock> blocks) {
    Matrix& matrix = factors_->matrix;
    std::fill(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros(), 0.0);
    for (std::size_t i = 0; i < diagonal.size(); ++i)
        if (position_[i] >= 0) add_diagonal(position_[i], {diagonal[i], 0, 0, diagonal[i], 0, diagonal[i]});
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Place& place = places_[i];
        if (place.a >= 0) add_diagonal(place.a, blocks[i]);
        if (place.b >= 0) add_diagonal(place.b, blocks[i]);
        if (place.a >= 0) add_beside(place, blocks[i]);
    }
    factors_->ldlt.factorize(matrix);
    return factors_->ldlt.info() == Eigen::Success && (free_ == 0 || factors_->ldlt.vectorD().minCoeff() > 0);
}

void BlockSolver::solve(std::span<const Vec3> b, std::span<Vec3> u) {
    Eigen::VectorXd& right = factors_->right;
    for (std::size_t i = 0; i < b.size(); ++i)
        if (position_[i] >= 0) right.segment<3>(3 * position_[i]) << b[i].x, b[i].y, b[i].z;
    factors_->solution = factors_->ldlt.solve(right);
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = {};
        if (position_[i] < 0) continue;
        const auto part = factors_->solution.segment<3>(3 * position_[i]);
        u[i] = {part[0], part[1], part[2]};
    }
}

std::size_t BlockSolver::memory_bytes() const noexcept {
    constexpr std::size_t kEntry = sizeof(double) + sizeof(std::int32_t);
    const auto entries = static_cast<std::size_t>(factors_->matrix.nonZeros() +
                                                  factors_->ldlt.matrixL().nestedExpression().nonZeros());
    return entries * kEntry + places_.capacity() * sizeof(Place) + position_.capacity() * sizeof(std::int32_t);
}

}  // namespace orbweaver::mass_spring
