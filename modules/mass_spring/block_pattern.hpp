#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "network.hpp"

namespace orbweaver::mass_spring {

/// Where the 3x3 blocks of a network's symmetric matrix and of its Cholesky factor lie: a column for every free
/// particle, ordered by approximate minimum degree (Amestoy, Davis and Duff 1996). The diagonal blocks come
/// first, one per column; below them, column by column, those that elimination leaves nonzero.
class BlockPattern {
public:
    explicit BlockPattern(const Network& network);

    /// Where a spring's block is added: at the diagonals of its ends, and beside them. -1: the end is fixed.
    struct Place {
        std::int32_t a = -1;  ///< the further up
        std::int32_t b = -1;
        std::int32_t beside = -1;
    };

    std::size_t columns() const noexcept { return begins_.size() - 1; }
    std::size_t blocks() const noexcept { return columns() + rows_.size(); }
    std::int32_t column_of(std::size_t particle) const noexcept { return columns_[particle]; }  ///< -1: fixed
    std::span<const Place> places() const noexcept { return places_; }
    /// The rows below the diagonal of a column, ascending, and the first one's block.
    std::span<const std::int32_t> rows(std::size_t column) const noexcept {
        return {rows_.data() + begins_[column], rows_.data() + begins_[column + 1]};
    }
    std::size_t first_block(std::size_t column) const noexcept { return columns() + begins_[column]; }
    /// The blocks (i, j) that eliminating columns 0, 1, ... changes, in that order: for every j of rows(k), for
    /// every i >= j of rows(k).
    std::span<const std::int32_t> targets() const noexcept { return targets_; }
    std::size_t memory_bytes() const noexcept;

private:
    using Neighbors = std::vector<std::vector<std::int32_t>>;  ///< per column, rows below

    void order(const Network& network);
    Neighbors joined(const Network& network) const;
    void fill_in(Neighbors below);
    void list_targets();
    void place_springs(const Network& network);
    std::int32_t block_at(std::int32_t row, std::int32_t column) const noexcept;

    std::vector<std::int32_t> columns_;  ///< of each particle
    std::vector<std::size_t> begins_{0};
    std::vector<std::int32_t> rows_;
    std::vector<std::int32_t> targets_;
    std::vector<Place> places_;
};

}  // namespace orbweaver::mass_spring
