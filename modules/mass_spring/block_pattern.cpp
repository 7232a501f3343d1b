#include "block_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <iterator>

namespace orbweaver::mass_spring {

BlockPattern::BlockPattern(const Network& network) { build(network, {}); }

std::optional<BlockPattern> BlockPattern::within(const Network& network, const FactorLimit& limit) {
    std::optional<BlockPattern> pattern = BlockPattern();
    if (!pattern->build(network, limit)) pattern.reset();
    return pattern;
}

bool BlockPattern::build(const Network& network, const FactorLimit& limit) {
    order(network);
    if (!fill_in(joined(network), limit)) return false;
    list_targets();
    place_springs(network);
    return true;
}

void BlockPattern::order(const Network& network) {
    columns_.assign(network.size(), -1);
    std::int32_t free = 0;
    for (std::size_t i = 0; i < network.size(); ++i)
        if (network.fixed[i] == 0) columns_[i] = free++;
    begins_.resize(static_cast<std::size_t>(free) + 1);
    std::vector<Eigen::Triplet<double, std::int32_t>> entries;
    entries.reserve(columns() + 2 * network.springs.size());
    for (std::int32_t i = 0; i < free; ++i) entries.emplace_back(i, i, 1.0);
    for (const Spring& s : network.springs) {
        const std::int32_t a = columns_[s.a], b = columns_[s.b];
        if (a < 0 || b < 0) continue;
        entries.emplace_back(a, b, 1.0);
        entries.emplace_back(b, a, 1.0);
    }
    Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t> graph(free, free);
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t> inverse;
    Eigen::AMDOrdering<std::int32_t>()(graph, inverse);  // new place -> old place
    std::vector<std::int32_t> moved(columns());
    for (std::int32_t i = 0; i < free; ++i) moved[static_cast<std::size_t>(inverse.indices()[i])] = i;
    for (std::int32_t& column : columns_)
        if (column >= 0) column = moved[static_cast<std::size_t>(column)];
}

BlockPattern::Neighbors BlockPattern::joined(const Network& network) const {
    Neighbors below(columns());
    for (const Spring& s : network.springs) {
        const auto [first, second] = std::minmax(columns_[s.a], columns_[s.b]);
        if (first >= 0) below[static_cast<std::size_t>(first)].push_back(second);
    }
    for (auto& rows : below) {
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    }
    return below;
}

// Eliminating a column joins its rows to each other; the topmost of them, its parent, hands that on.
bool BlockPattern::fill_in(Neighbors below, const FactorLimit& limit) {
    std::vector<std::int32_t> merged;
    for (std::size_t column = 0; column < columns(); ++column) {
        const auto& rows = below[column];
        updates_ += rows.size() * (rows.size() + 1) / 2;
        if (updates_ > limit.updates || columns() + rows_.size() + rows.size() > limit.blocks) return false;
        begins_[column] = rows_.size();
        rows_.insert(rows_.end(), rows.begin(), rows.end());
        if (rows.empty()) continue;
        auto& parent = below[static_cast<std::size_t>(rows.front())];
        merged.clear();
        std::set_union(parent.begin(), parent.end(), rows.begin() + 1, rows.end(), std::back_inserter(merged));
        parent = merged;
    }
    begins_.back() = rows_.size();
    return true;
}

std::int32_t BlockPattern::block_at(std::int32_t row, std::int32_t column) const noexcept {
    if (row == column) return row;
    const auto at = static_cast<std::size_t>(column);
    const auto in = rows(at);
    const auto found = std::lower_bound(in.begin(), in.end(), row);
    return static_cast<std::int32_t>(first_block(at)) + static_cast<std::int32_t>(found - in.begin());
}

void BlockPattern::list_targets() {
    targets_.reserve(updates_);
    for (std::size_t k = 0; k < columns(); ++k) {
        const auto eliminated = rows(k);
        for (std::size_t j = 0; j < eliminated.size(); ++j)
            for (std::size_t i = j; i < eliminated.size(); ++i)
                targets_.push_back(block_at(eliminated[i], eliminated[j]));
    }
}

void BlockPattern::place_springs(const Network& network) {
    for (const Spring& s : network.springs) {
        const auto [first, second] = std::minmax(columns_[s.a], columns_[s.b]);
        places_.push_back({first, second, first < 0 ? -1 : block_at(second, first)});
    }
}

std::size_t BlockPattern::memory_bytes() const noexcept {
    return (columns_.capacity() + rows_.capacity() + targets_.capacity()) * sizeof(std::int32_t) +
           begins_.capacity() * sizeof(std::size_t) + places_.capacity() * sizeof(Place);
}

}  // namespace orbweaver::mass_spring
